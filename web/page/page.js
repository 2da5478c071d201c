// The page: what is typed, pressed and dragged becomes questions, and replies are put where they
// belong.
const [lead, mover, searcher] = [new Asker(), new Asker(), new Asker()]
const $ = id => document.getElementById(id)
let state = readAddress()
let catalog = []
let sheetOf = null // the answer to `show` for the field as it is, or null where it has a mistake
let integrals = [] // the lines of integrals that were found
let frame = null // what the portrait shows: its sheet, its window

const entry = () => catalog.find(({ name }) => name === state.system)
const subject = () => {
  const named = Object.entries(state.params).filter(([name, value]) => NUMBER.test(value) && new RegExp(`\\b${name}\\b`).test(state.field))
  return { ...(entry() ? { name: state.system } : { field: state.field }), params: Object.fromEntries(named) }
}
const save = () => history.replaceState(null, '', address(state))

// --- The field and its formulas

function choose(change) {
  state = { ...START, system: '', ...change }
  searcher.stop()
  open()
}

function open() {
  const known = entry()
  if (known) state = { ...state, field: known.text, params: { ...known.params, ...state.params } }
  $('field').value = state.field
  $('steps').value = state.steps
  $('gallery').value = state.system
  return refresh()
}

async function refresh() {
  const wasSearching = searcher.isBusy && $('search').classList.contains('running')
  forget()
  const reply = await lead.ask(subject(), { ask: 'show' })
  if (!reply) return
  $('mistake').hidden = !reply.mistake
  $('mistake').textContent = reply.mistake || ''
  $('field').setAttribute('aria-invalid', String(Boolean(reply.mistake)))
  document.body.classList.toggle('stale', Boolean(reply.mistake))
  if (reply.mistake) { sheetOf = null; return }
  sheetOf = reply.answer
  $('formulas').innerHTML = reply.html
  parameters(reply.parameters)
  if (wasSearching) search()
  if ($('jacobian').open) await jacobian()
  await orbitsAnew()
}

// Results that were of another field.
function forget() {
  searcher.stop()
  integrals = []
  for (const id of ['kept', 'heights-shown', 'poles-shown', 'stage', 'heights-stage', 'poles-stage', 'copied', 'linked']) $(id).replaceChildren()
  $('arrived').hidden = true
  $('jacobian').lastElementChild.replaceChildren()
  for (const id of ['search', 'heights', 'poles']) $(id).classList.remove('running')
}

function parameters(names) {
  const box = $('parameters')
  if (names.join() === [...box.querySelectorAll('input')].map(input => input.name).join()) {
    for (const input of box.querySelectorAll('input')) if (input !== document.activeElement) input.value = state.params[input.name] || ''
    return
  }
  box.replaceChildren(...names.map(name => {
    const label = document.createElement('label')
    const input = Object.assign(document.createElement('input'), { name, value: state.params[name] || '', size: 7, placeholder: 'generic' })
    input.oninput = () => {
      state.params = { ...state.params, [name]: input.value.trim() }
      input.setAttribute('aria-invalid', String(Boolean(input.value) && !NUMBER.test(input.value.trim())))
      later(refresh)
    }
    label.append(`${name} = `, input)
    return label
  }))
}

async function jacobian() {
  const reply = await lead.ask(subject(), { ask: 'show', jacobian: true })
  if (reply && !reply.mistake) $('jacobian').lastElementChild.innerHTML = reply.html
}

let timer = 0
const later = work => { clearTimeout(timer); timer = setTimeout(work, 120) }

async function copy(kind) {
  const reply = await lead.ask(subject(), { ask: 'show', as: kind, jacobian: kind !== 'kahan' })
  if (!reply) return
  $('copied').textContent = (await copied(reply.mistake || written(reply.answer, kind))) ? 'Copied.' : ''
}

async function copied(text) {
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    prompt('To be copied:', text)
    return false
  }
}

// The formulas of a sheet, a line each.
function written(answer, kind) {
  if (kind === 'kahan') return answer.macro
  if (kind === 'sympy') return answer.script
  const [name, row, open, close] = kind === 'latex'
    ? [v => `\\widetilde{${v}}`, rows => rows.map(row => row.join(' & ')).join(' \\\\ '), '\\begin{pmatrix} ', ' \\end{pmatrix}']
    : [v => `${v}~`, rows => rows.map(row => `[${row.join(', ')}]`).join(', '), '[', ']']
  const matrix = (called, rows) => (rows ? [`${called} = ${open}${row(rows)}${close}`] : [])
  const map = answer.map || answer.variables.map(() => '(beyond the budget of terms)')
  return [
    ...answer.variables.map((v, k) => `${name(v)} = ${map[k]}`),
    ...matrix('A', answer.A), ...matrix('b', answer.b.map(value => [value])), ...matrix('J', answer.jacobian),
  ].join('\n')
}

// --- What the map keeps, heights, poles: long work, one at a time

// Asks while a button says so; pressed once more, the button ends it.
async function long(id, question, hears, shows) {
  const button = $(id)
  if (button.classList.contains('running')) { searcher.stop(); return }
  const stage = $(id === 'search' ? 'stage' : `${id}-stage`)
  const reply = searcher.ask(subject(), question, data => {
    const { what, done, of } = data.look || {}
    if (what) stage.textContent = of ? `${done} of ${of} ${what}` : `${what} …`
    hears(data)
  })
  button.classList.add('running')
  const heard = await reply
  button.classList.remove('running')
  stage.textContent = heard?.mistake || ''
  if (heard && !heard.mistake) shows(heard)
}

function search() {
  const list = $('arrived')
  list.textContent = ''
  return long('search', { ask: 'discover', seconds: 30 }, ({ found }) => {
    if (!found) return
    list.hidden = false
    list.textContent += `${found.text}\n`
  }, ({ answer, html }) => {
    $('kept').innerHTML = html
    const lines = [...answer.integrals, ...answer.densities, ...answer.brackets]
    list.textContent = lines.join('\n')
    list.hidden = !lines.length
    $('stage').textContent = `${answer.independent_integrals} independent integrals; growth of degrees: ${answer.growth}. Found in ${answer.seconds.toFixed(1)} s.`
    integrals = answer.integrals.filter(line => !/\bwhen\b/.test(line))
    move()
  })
}

// --- Orbits

// The field with integrals: its own, or those that were found.
function kept() {
  if (!integrals.length || sheetOf.claims.some(({ kind }) => kind === 'integral')) return subject()
  const equations = sheetOf.variables.map((name, k) => `${name}dot = ${sheetOf.field[k]};`)
  const text = [...equations, ...integrals].join('\n')
  const named = Object.entries(subject().params).filter(([name]) => new RegExp(`\\b${name}\\b`).test(text))
  return { field: text, params: Object.fromEntries(named) }
}

async function orbitsAnew() {
  const { variables } = sheetOf
  const fits = state.at.length && state.at.every(at => at.split(',').length === variables.length)
  if (!state.eps || !fits) {
    const scene = await lead.ask(subject(), { ask: 'scene' })
    if (!scene) return
    if (scene.mistake) {
      $('ended').textContent = scene.mistake
      $('panes').hidden = true
      return
    }
    state.eps ||= decimal(valueOf(scene.answer.eps))
    if (!fits) state.at = [scene.answer.at.join(',')]
  }
  if (!state.axes.every(name => name === 't' || variables.includes(name)) || state.axes.length !== 2) {
    state.axes = variables.length > 1 ? variables.slice(0, 2) : ['t', variables[0]]
  }
  for (const [id, k] of [['across', 0], ['upwards', 1]]) {
    $(id).replaceChildren(...['t', ...variables].map(name => new Option(name, name, false, name === state.axes[k])))
  }
  frame = null
  fields()
  await move()
}

const decimal = (number, digits = 3) => String(Number(number.toPrecision(digits)))
// The slider goes over four powers of ten.
const ofSlider = place => decimal(10 ** (place / 100 - 4))

function fields() {
  const eps = valueOf(state.eps)
  if (document.activeElement !== $('eps')) $('eps').value = state.eps
  if (document.activeElement !== $('at')) $('at').value = state.at.at(-1) || ''
  if (document.activeElement !== $('slider')) $('slider').value = Math.round(100 * (Math.log10(Math.abs(eps)) + 4))
  $('slider').setAttribute('aria-valuetext', `ε = ${state.eps}, Δt = ${short(2 * eps)}`)
  $('dt').textContent = `Δt = 2ε = ${short(2 * eps)}`
  for (const box of $('methods').querySelectorAll('input')) box.checked = box.value === 'kahan' || state.beside.includes(box.value)
}

let isMoving = false
let isOvertaken = false

// Draws the orbits as they are now. While they are computed, later wishes become one.
async function move() {
  save()
  if (!sheetOf || !state.at.length) return
  if (isMoving) { isOvertaken = true; return }
  isMoving = true
  do {
    isOvertaken = false
    await orbits()
  } while (isOvertaken)
  isMoving = false
}

async function orbits() {
  const [sheet, asked, methods] = [sheetOf, kept(), ['kahan', ...state.beside]]
  const drawn = []
  let said = ''
  for (const method of methods) {
    for (const at of state.at) {
      const steps = method === 'flow' ? Math.min(state.steps, 2000) : state.steps
      const reply = await mover.ask(asked, { ask: 'orbit', eps: state.eps, at: at.split(','), steps, method })
      if (!reply || sheet !== sheetOf) return
      if (reply.mistake) {
        $('ended').textContent = reply.mistake
        $('panes').hidden = true
        return
      }
      const { head, rows, stopped } = reply.answer
      const columns = head.columns.map((_, k) => reply.columns.subarray(k * rows, (k + 1) * rows))
      const first = 2 + head.variables.length
      drawn.push({ names: head.columns, method, columns, integrals: head.columns.map((_, k) => k).slice(first), paint: METHODS[method][1] })
      if (stopped) said = `${METHODS[method][0]}: ${stopped}`
    }
  }
  $('ended').textContent = said || `${state.at.length * (state.steps + 1)} points of ${state.at.length === 1 ? 'one orbit' : `${state.at.length} orbits`}`
  show(drawn)
}

let lastDrawn = []
function show(drawn) {
  lastDrawn = drawn
  $('panes').hidden = false
  const places = state.axes.map(name => (name === 't' ? 1 : 2 + sheetOf.variables.indexOf(name)))
  const own = drawn.filter(({ method }) => method === 'kahan')
  const window = frame?.window || places.map(k => span((frame?.isWhole ? drawn : own).map(({ columns }) => columns[k]), frame?.isWhole))
  const measured = drawn.filter(({ integrals }, k) => integrals.length && (k === 0 || drawn[k - 1].method !== drawn[k].method))
  $('drift').parentElement.hidden = !measured.length
  $('drifting').textContent = measured.length ? `Largest relative change of ${measured[0].integrals.map(k => measured[0].names[k]).join(', ')} along the first orbit` : ''
  // The map itself lies above what it is compared with.
  const sets = [...drawn].reverse().map(({ columns, paint }) => ({ xs: columns[places[0]], ys: columns[places[1]], paint }))
  const starts = own.map(({ columns }) => places.map(k => columns[k][0]))
  frame = { ...portrait($('portrait'), window, state.axes, sets, starts), starts, window }
  $('portrait').setAttribute('aria-label', `${state.axes[1]} against ${state.axes[0]} on ${own.length} orbits of ${state.steps} steps from ${state.at.join('; ')} at eps ${state.eps}`)
  if (measured.length) drift($('drift'), measured)
}

// Moves a first point to where the pointer is in the plane of the axes.
function put(index, [x, y]) {
  const coordinates = state.at[index].split(',')
  state.axes.forEach((name, k) => {
    const place = sheetOf.variables.indexOf(name)
    if (place >= 0) coordinates[place] = decimal([x, y][k], 4)
  })
  state.at = state.at.toSpliced(index, 1, coordinates.join(','))
  fields()
  move()
}

function dragging() {
  const canvas = $('portrait')
  let held = -1
  const place = event => [event.offsetX, event.offsetY]
  canvas.onpointerdown = event => {
    if (!frame || !sheetOf) return
    const [px, py] = place(event)
    held = frame.starts.findIndex(([x, y]) => Math.hypot(frame.x(x) - px, frame.y(y) - py) < 14)
    if (held < 0) {
      if (state.at.length >= 12) return
      held = state.at.length
      state.at = [...state.at, state.at.at(-1)]
      put(held, frame.point(px, py))
    }
    canvas.setPointerCapture(event.pointerId)
  }
  canvas.onpointermove = event => { if (held >= 0) put(held, frame.point(...place(event))) }
  canvas.onpointerup = canvas.onpointercancel = () => { held = -1 }
  canvas.onkeydown = event => {
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key]
    if (!by || !frame) return
    event.preventDefault()
    put(state.at.length - 1, frame.starts.at(-1).map((value, k) => value + by[k] * (frame.window[k][1] - frame.window[k][0]) / 50))
  }
}

// --- The page as a whole

function button(text, act) {
  const made = Object.assign(document.createElement('button'), { textContent: text, className: 'quiet', onclick: act })
  const item = document.createElement('li')
  item.append(made)
  return item
}

const upToTop = () => scrollTo({ top: 0 })
const group = (label, options) => {
  const made = Object.assign(document.createElement('optgroup'), { label })
  made.append(...options)
  return made
}

function gallery() {
  $('classical').replaceChildren(...CLASSICAL.map(({ name, ...change }) => button(name, () => { choose(change); upToTop() })))
  $('gallery').replaceChildren(
    new Option('a field of your own', ''),
    group('Classical systems', CLASSICAL.map(({ name }, k) => new Option(name, `#${k}`))),
  )
  $('gallery').onchange = ({ target: { value } }) => choose(value.startsWith('#') ? CLASSICAL[value.slice(1)] : value ? { system: value } : { field: state.field })
}

// The catalog joins what stands there, under the hands of whoever is choosing.
async function list() {
  catalog = (await new Asker().ask(undefined, { ask: 'list' })).answer
  $('catalog').replaceChildren(...catalog.map(({ name, called, title }) => {
    const item = button(called, () => { choose({ system: name }); upToTop() })
    item.append(` ${title}`)
    return item
  }))
  $('gallery').append(group('The catalog', catalog.map(({ name, called, title }) => new Option(`${called}: ${title}`, name))))
}

function wire() {
  $('field').oninput = () => {
    state = { ...state, system: '', field: $('field').value, eps: '', at: [] }
    $('gallery').value = ''
    later(refresh)
  }
  $('jacobian').ontoggle = () => { if ($('jacobian').open && sheetOf) jacobian() }
  for (const made of document.querySelectorAll('[data-copy]')) made.onclick = () => copy(made.dataset.copy)
  $('search').onclick = search
  $('heights').onclick = () => long('heights', { ask: 'heights', eps: state.eps, at: state.at.at(-1).split(','), steps: 60, max_digits: 20000, seconds: 10 }, () => {}, ({ answer, html }) => {
    $('heights-shown').innerHTML = html
    $('heights-stage').textContent = `Growth is ${answer.growth}, over ${answer.steps} steps.`
  })
  $('poles').onclick = () => long('poles', { ask: 'poles', seconds: 20 }, () => {}, ({ html, answer }) => {
    $('poles-shown').innerHTML = html
    $('poles-stage').textContent = `The degrees of the iterates are ${answer.degrees.join(', ')}: growth is ${answer.growth}.`
  })
  $('slider').oninput = () => { state.eps = ofSlider($('slider').value); fields(); move() }
  $('eps').oninput = () => { if (NUMBER.test($('eps').value)) { state.eps = $('eps').value; fields(); move() } }
  $('at').onchange = () => {
    const parts = $('at').value.split(',').map(part => part.trim())
    if (parts.length !== sheetOf?.variables.length || !parts.every(part => NUMBER.test(part))) return
    state.at = [...state.at.slice(0, -1), parts.join(',')]
    frame = null
    move()
  }
  $('steps').onchange = () => { state.steps = Math.min(1e6, Math.max(1, Math.round($('steps').value) || 1)); $('steps').value = state.steps; frame = null; move() }
  for (const [id, k] of [['across', 0], ['upwards', 1]]) $(id).onchange = () => { state.axes[k] = $(id).value; frame = null; save(); show(lastDrawn) }
  $('methods').replaceChildren(...Object.entries(METHODS).map(([name, [called, paint]]) => {
    const label = document.createElement('label')
    const box = Object.assign(document.createElement('input'), { type: 'checkbox', value: name, disabled: name === 'kahan' })
    box.onchange = () => { state.beside = [...$('methods').querySelectorAll('input')].filter(({ checked, disabled }) => checked && !disabled).map(({ value }) => value); move() }
    const dot = Object.assign(document.createElement('span'), { className: 'dot' })
    dot.style.background = `var(${paint})`
    label.append(box, dot, called)
    return label
  }))
  $('fewer').onclick = () => { state.at = state.at.slice(0, 1); frame = null; fields(); move() }
  $('whole').onclick = () => { frame = { isWhole: true }; show(lastDrawn) }
  $('link').onclick = async () => { save(); $('linked').textContent = (await copied(location.href)) ? 'Copied.' : '' }
  dragging()
  const again = () => { if (sheetOf && lastDrawn.length) show(lastDrawn) }
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again)
  addEventListener('resize', again)
  addEventListener('hashchange', () => { state = readAddress(); open() })
}

async function begin() {
  wire()
  const { answer, mistake } = await lead.ask(undefined, { ask: 'style' })
  $('mistake').hidden = !mistake
  $('mistake').textContent = mistake || ''
  document.head.prepend(Object.assign(document.createElement('style'), { textContent: answer || '' }))
  document.body.classList.add('ready')
  if (mistake) return
  gallery()
  // The catalog takes longer than the first formulas, and so waits for them, but where they are of
  // one of its systems.
  if (state.system) {
    await list()
    open()
  } else {
    await open()
    list()
  }
}
begin()
