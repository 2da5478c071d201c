// The page: what is typed, pressed and dragged becomes questions, and replies are put where they
// belong.
const [lead, mover, follower] = [new Asker(), new Asker(), new Asker()]
const workers = { search: new Asker(), heights: new Asker(), poles: new Asker() }
const $ = id => document.getElementById(id)
let state = readAddress()
let chosen = { eps: false, at: false } // whether the reader or the address gave ε and the first points
let isFromGallery = !location.hash // whether these are those of an entry of the gallery
let catalog = []
let sheetOf = null // the answer to `show` for the field as it is, or null where it has a mistake
let lifted = null // what `show` says of the lift, where there is one
let values = {} // of the parameters that have some
let searched = null // the subject of the search, its equations and what was found
let frame = null // what the portrait shows: its sheet, its window

const entry = () => catalog.find(({ name }) => name === state.system)
const named = text => Object.fromEntries(Object.entries(state.params).filter(([name, value]) => NUMBER.test(value) && new RegExp(`\\b${name}\\b`).test(text)))
const subject = () => ({ ...(entry() ? { name: state.system } : { field: state.field, ...lifting() }), params: named(state.field) })
const lifting = () => (state.lift ? { lift: state.lift } : {})
// The variables of first points and pictures.
const pointVariables = () => lifted?.coordinates || sheetOf.variables
const save = () => history.replaceState(null, '', address({ ...state, params: named(state.field) }))

// A sentence, its formulas between backticks.
const say = (id, text) => $(id).replaceChildren(...text.split('`').map((part, k) => (k % 2 ? Object.assign(document.createElement('code'), { textContent: part }) : part)))

// --- The field and its formulas

function choose(change) {
  isFromGallery = true
  state = { ...START, ...change }
  open()
}

function open() {
  const known = entry()
  if (known) state = { ...state, field: known.text, params: { ...known.params, ...state.params } }
  chosen = { eps: Boolean(state.eps), at: Boolean(state.at.length) }
  $('field').value = state.field
  $('steps').value = state.steps
  $('gallery').value = state.system || `#${CLASSICAL.findIndex(({ field }) => field === state.field)}`
  if ($('gallery').selectedIndex < 0) $('gallery').value = ''
  forget()
  return refresh()
}

// The field is another one.
function typed() {
  state = { ...state, system: '', field: $('field').value }
  $('gallery').value = ''
  save()
  forget()
  later(refresh)
}

async function refresh() {
  const reply = await lead.ask(subject(), { ask: 'show', as: 'latex' })
  if (!reply) return
  $('mistake').hidden = $('first').hidden = !reply.mistake
  $('offer').hidden = !reply.lifts
  $('lifting').hidden = !state.lift || !(reply.mistake || reply.lifted)
  $('which-lift').value = state.lift
  $('first').textContent = `${reply.lifts ? 'Lift or correct the field first.' : 'Correct the field first.'} What is below is of the field before.`
  $('mistake').textContent = reply.mistake || ''
  $('field').setAttribute('aria-invalid', String(Boolean(reply.mistake)))
  $('rest').disabled = Boolean(reply.mistake)
  ;[sheetOf, lastDrawn, relationErrors] = [reply.mistake ? null : reply.answer, [], []]
  if (!sheetOf) return
  lifted = reply.lifted
  showLift()
  set('formulas', reply.html)
  values = reply.values
  parameters(reply.parameters)
  // Formulas are painted before more work begins; a tab behind others paints nothing.
  await new Promise(ends => { requestAnimationFrame(ends); setTimeout(ends, 100) })
  if (sheetOf !== reply.answer) return
  if (isWanted) search()
  if ($('jacobian').open) await jacobian()
  await orbitsAnew()
}

function showLift() {
  $('lifted').hidden = !lifted
  if (!lifted) return
  set('lift-shown', lifted.html)
  $('growing').hidden = !lifted.warning
  $('growing').textContent = lifted.warning ? `Note: ${lifted.warning}.` : ''
  // The heading says where the answer stands, as the button is gone.
  if (isLifting) $('h-lift').focus()
  isLifting = false
}

let isLifting = false // whether a lift was asked for by the button

// Another lift of the same text, or none.
function lift(which) {
  state = { ...state, lift: which, system: '' }
  save()
  forget()
  return refresh()
}

// Boxes that scroll are stops for the keyboard, with a name; others are none.
const stops = new ResizeObserver(seen => {
  for (const { target: box } of seen) {
    const label = box.closest('.preserved')?.querySelector('.source')?.textContent || 'A formula or a table wider than the page'
    if (box.scrollWidth > box.clientWidth) Object.assign(box, { tabIndex: 0, role: 'region', ariaLabel: label })
    else for (const name of ['tabindex', 'role', 'aria-label']) box.removeAttribute(name)
  }
})

// Puts in what was set and drawn.
function set(id, html) {
  $(id).innerHTML = html.replace(/`([^`<>]*)`/g, '<code>$1</code>')
  for (const box of $(id).querySelectorAll('[tabindex]')) stops.observe(box)
}

let isWanted = false // whether a search begins as soon as the field has no mistake

// Results that are no longer true: of another field all, of another value of a parameter those that
// were found for the one before. A search that is under way begins anew.
function forget(changed) {
  const holds = changed && !(changed in (searched?.subject.params || {}))
  isWanted ||= $('search').classList.contains('running') && !holds
  for (const name of Object.keys(workers)) {
    if (name === 'search' && holds) continue
    workers[name].stop()
    $(name).classList.remove('running')
    for (const id of [`${name}-shown`, `${name}-stage`]) $(id).replaceChildren()
  }
  for (const id of ['copied', 'copied-found', 'linked']) $(id).replaceChildren()
  $('jacobian-shown').replaceChildren()
  if (!holds) {
    searched = null
    $('arrived').hidden = $('copies-found').hidden = true
  } else if (searched?.equations) $('search-stage').textContent = `This was found for generic ${changed}, and so holds at its value, too.`
}

function parameters(names) {
  const box = $('parameters')
  if (names.join() === [...box.querySelectorAll('input')].map(input => input.name).join()) {
    for (const input of box.querySelectorAll('input')) {
      input.placeholder = values[input.name] || 'generic'
      if (input !== document.activeElement) input.value = state.params[input.name] || ''
    }
    return
  }
  box.replaceChildren(...names.map(name => {
    const label = document.createElement('label')
    const input = Object.assign(document.createElement('input'), { name, value: state.params[name] || '', size: 7, placeholder: values[name] || 'generic' })
    input.oninput = () => {
      state.params = { ...state.params, [name]: input.value.trim() }
      input.setAttribute('aria-invalid', String(Boolean(input.value) && !NUMBER.test(input.value.trim())))
      save()
      forget(name)
      later(refresh)
    }
    label.append(`${name} = `, input)
    return label
  }))
}

async function jacobian() {
  const reply = await lead.ask(subject(), { ask: 'show', as: 'latex', jacobian: true })
  if (reply && !reply.mistake) set('jacobian-shown', reply.html)
}

let timer = 0
const later = work => { clearTimeout(timer); timer = setTimeout(work, 120) }

async function copy(kind, button) {
  const withJacobian = $('jacobian').open && kind !== 'kahan'
  const reply = await lead.ask(subject(), { ask: 'show', as: kind, jacobian: withJacobian })
  if (!reply) return
  const what = kind === 'kahan' ? 'the field' : `the map, A, b${withJacobian ? ' and the Jacobian' : ''}`
  copied('copied', `${what} as ${button.textContent}`, reply.mistake || written(reply.answer, kind))
}

// What was found, in the language of `kahan!` or in LaTeX.
async function copyFound(kind) {
  if (kind === 'text') { copied('copied-found', 'what was found as text', searched.lines.join('\n')); return }
  const reply = await lead.ask(claimed(searched.lines), { ask: 'show', as: 'latex' })
  if (!reply) return
  const lines = reply.mistake || reply.answer.claims.flatMap(({ equations }) => equations.map(sides => sides.join(' = '))).join('\n')
  copied('copied-found', 'what was found as LaTeX', lines)
}

async function copied(id, what, text) {
  try {
    await navigator.clipboard.writeText(text)
    $(id).textContent = `Copied ${what}.`
  } catch {
    prompt(`To be copied, ${what}:`, text)
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

// --- What the map keeps, heights, poles: long work

// Asks while a button says so; pressed once more, the button ends it.
async function long(id, question, shows, hears = () => {}) {
  const button = $(id)
  if (button.classList.contains('running')) { workers[id].stop(); return }
  const stage = $(`${id}-stage`)
  stage.replaceChildren()
  button.classList.add('running')
  const reply = await workers[id].ask(subject(), question, data => {
    const { what, done, of } = data.look || {}
    if (what) stage.textContent = of ? `${done} of ${of} ${what}` : `${what} …`
    hears(data)
  })
  // The field has changed, and the button is as it was.
  if (!reply && !button.classList.contains('running')) return
  button.classList.remove('running')
  say(stage.id, reply ? reply.mistake || '' : 'Stopped.')
  if (reply && !reply.mistake) shows(reply)
}

function search() {
  const [list, asked] = [$('arrived'), subject()]
  isWanted = false
  if (!$('search').classList.contains('running')) {
    searched = { subject: asked }
    list.textContent = ''
    $('copies-found').hidden = true
  }
  return long('search', { ask: 'discover', seconds: 30 }, async ({ answer, html }) => {
    set('search-shown', html)
    const lines = [...answer.integrals, ...answer.densities, ...answer.brackets, ...answer.drifts]
    list.textContent = lines.join('\n')
    list.hidden = $('copies-found').hidden = !lines.length
    $('search-stage').textContent = `${answer.independent_integrals} independent integrals; growth of degrees: ${answer.growth}${answer.growth_proved ? ', proved' : ''}. Found in ${answer.seconds.toFixed(1)} s.`
    // Claims say for which values of parameters they are made, so the equations name these.
    const sheet = await workers.search.ask({ ...asked, params: {} }, { ask: 'show' })
    if (!sheet?.answer || searched?.subject !== asked) return
    const right = sheet.answer.field_at_eps ?? sheet.answer.field
    const equations = sheet.answer.variables.map((name, k) => `${name}dot = ${right[k]};`)
    searched = { ...searched, equations, lines, integrals: answer.integrals }
    move()
  }, ({ found }) => {
    if (!found) return
    list.hidden = false
    list.textContent += `${found.text}\n`
  })
}

// --- Orbits

// The field of the search with some of what was found.
function claimed(lines) {
  // A lift takes claims behind the equations as they are written, and points in their variables.
  if (lifted) return { ...searched.subject, field: [searched.subject.field, ...lines].join('\n') }
  const field = [...searched.equations, ...lines].join('\n')
  const params = named(field)
  // The values that the text itself gives.
  const own = Object.entries(values).filter(([name]) => !(name in params) && new RegExp(`\\b${name}\\b`).test(field))
  return { field: [...own.map(([name, value]) => `${name} = ${value};`), field].join('\n'), params }
}

// The field with integrals: its own, or those that were found.
function measured() {
  const integrals = searched?.integrals || []
  return integrals.length && !sheetOf.claims.some(({ kind }) => kind === 'integral') ? claimed(integrals) : subject()
}

async function orbitsAnew() {
  const variables = pointVariables()
  const fits = state.at.length && state.at.every(at => at.split(',').length === variables.length)
  if (!chosen.eps || !chosen.at || !fits) {
    const scene = await lead.ask(subject(), { ask: 'scene' })
    if (!scene) return
    if (scene.mistake) { undrawn(scene.mistake); return }
    if (!chosen.eps) state.eps = decimal(valueOf(scene.answer.eps))
    if (!chosen.at || !fits) [chosen.at, state.at] = [false, [scene.answer.at.join(',')]]
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

// No orbit can be drawn, and so none is.
function undrawn(mistake) {
  say('ended', mistake)
  lastDrawn = []
  $('panes').hidden = true
}

const decimal = (number, digits = 3) => String(Number(number.toPrecision(digits)))
// The slider goes over four powers of ten.
const ofSlider = place => decimal(10 ** (place / 100 - 4))

function fields() {
  const eps = valueOf(state.eps)
  if (document.activeElement !== $('eps')) $('eps').value = state.eps
  if (document.activeElement !== $('at')) $('at').value = state.at.at(-1) || ''
  $('which').textContent = state.at.length > 1 ? `first point of orbit ${state.at.length}` : 'first point'
  if (document.activeElement !== $('slider')) $('slider').value = Math.round(100 * (Math.log10(Math.abs(eps)) + 4))
  $('slider').setAttribute('aria-valuetext', `ε = ${state.eps}, Δt = ${short(2 * eps)}`)
  $('dt').textContent = `Δt = 2ε = ${short(2 * eps)}`
  for (const box of $('methods').querySelectorAll('input')) box.checked = box.value === 'kahan' || state.beside.includes(box.value)
}

// Work that is done anew as often as it is wished; wishes that come while it is done become one.
function merged(work) {
  let [isBusy, isOvertaken] = [false, false]
  return async () => {
    isOvertaken = isBusy
    if (isBusy) return
    isBusy = true
    do {
      isOvertaken = false
      await work()
    } while (isOvertaken)
    isBusy = false
  }
}

// Draws the orbits as they are now. The flow takes longer than the maps, and follows them.
const [moveMaps, moveFlow] = [merged(() => orbits(mover, ['kahan', ...state.beside.filter(name => name !== 'flow')])), merged(() => orbits(follower, ['flow']))]
function move() {
  save()
  if (!sheetOf || !state.at.length) return undefined
  if (state.beside.includes('flow')) moveFlow()
  return moveMaps()
}

// The errors of the relations of a lift along the first orbit of the map, and those drawn last.
let relationErrors = []
async function relations(asked) {
  const [{ at, eps, steps }, names] = [state, lifted?.relations || []]
  if (!names.length) return []
  const reply = await mover.ask(asked, { ask: 'relations', eps, at: at[0].split(','), steps })
  if (!reply || reply.mistake) return reply && []
  const { rows } = reply.answer
  return names.map((_, k) => reply.columns.subarray(k * rows, (k + 1) * rows))
}

async function orbits(asker, methods) {
  const [sheet, asked, { at: starts, eps }] = [sheetOf, measured(), state]
  const made = []
  for (const method of methods) {
    for (const at of starts) {
      const steps = method === 'flow' ? Math.min(state.steps, 2000) : state.steps
      const reply = await asker.ask(asked, { ask: 'orbit', eps, at: at.split(','), steps, method })
      if (!reply || sheet !== sheetOf) return
      if (reply.mistake) { undrawn(reply.mistake); return }
      const { head, rows, stopped, note } = reply.answer
      const columns = head.columns.map((_, k) => reply.columns.subarray(k * rows, (k + 1) * rows))
      const first = 2 + head.variables.length
      made.push({ names: head.columns, method, eps, at, columns, stopped, note, integrals: head.columns.map((_, k) => k).slice(first), paint: METHODS[method][1] })
    }
  }
  if (asker === mover) {
    const errors = await relations(asked)
    if (!errors || sheet !== sheetOf) return
    relationErrors = errors
  }
  const others = lastDrawn.filter(({ method }) => (method === 'flow') !== (asker === follower))
  const drawn = asker === follower ? [...others, ...made] : [...made, ...others]
  // A flow of other points is no longer shown.
  show(drawn.filter(({ method, eps, at }) => method !== 'flow' || state.beside.includes(method) && eps === state.eps && state.at.includes(at)))
}

let lastDrawn = []
function show(drawn) {
  lastDrawn = drawn
  const own = drawn.filter(({ method }) => method === 'kahan')
  if (!own.length) return
  $('panes').hidden = false
  const ended = drawn.find(({ stopped }) => stopped)
  $('ended').textContent = ended
    ? `${METHODS[ended.method][0]} blows up after ${ended.stopped.step} steps; the ${ended.stopped.step + 1} points before it are drawn.`
    : `${own.length * (state.steps + 1)} points of ${own.length === 1 ? 'one orbit' : `${own.length} orbits`}`
  const noted = own.find(({ note }) => note)
  if (noted) $('ended').textContent += `. Note: ${noted.note}.`
  const places = state.axes.map(name => (name === 't' ? 1 : 2 + pointVariables().indexOf(name)))
  const window = frame?.window || places.map(k => {
    const lists = orbits => orbits.map(({ columns }) => columns[k])
    const [low, high] = span(lists(own), frame?.isWhole)
    // What is compared with the map may have gone to infinity.
    return frame?.isWhole ? span(lists(drawn), true, [11 * low - 10 * high, 11 * high - 10 * low]) : [low, high]
  })
  const measured = drawn.filter(({ integrals }, k) => integrals.length && (k === 0 || drawn[k - 1].method !== drawn[k].method))
  const hasDrift = Boolean(measured.length || relationErrors.length)
  $('drift').parentElement.hidden = !hasDrift
  const integrals = measured.length ? measured[0].integrals.map(k => measured[0].names[k]).join(', ') : ''
  $('drifting').replaceChildren(...drifting(integrals))
  // The map itself lies above what it is compared with, which is drawn wider.
  const sets = [...drawn].reverse().map(({ columns, paint, method }) => ({ xs: columns[places[0]], ys: columns[places[1]], paint, wider: { kahan: 0, flow: 3 }[method] ?? 1.5 }))
  const starts = state.at.map(at => state.axes.map(name => (name === 't' ? 0 : valueOf(at.split(',')[pointVariables().indexOf(name)]))))
  frame = { ...portrait($('portrait'), window, state.axes, sets, starts), starts, window }
  $('portrait').setAttribute('aria-label', `${state.axes[1]} against ${state.axes[0]} on ${own.length} orbits of ${state.steps} steps from ${state.at.join('; ')} at eps ${state.eps}`)
  if (!hasDrift) return
  $('drift').setAttribute('aria-label', ['Drift of', integrals || 'nothing', ...(relationErrors.length ? ['and errors of', lifted.relations.join('; ')] : [])].join(' '))
  drift($('drift'), own[0].columns[1], measured, relationErrors, 2 * valueOf(own[0].eps) * state.steps)
}

// The lines of the drift plot.
function drifting(integrals) {
  const said = integrals ? [`Largest relative change of ${integrals} along the first orbit${relationErrors.length ? ', and' : ''}`] : []
  if (!relationErrors.length) return said
  const list = document.createElement('ul')
  list.append(...lifted.relations.map((relation, k) => {
    const [item, line, code] = ['li', 'span', 'code'].map(name => document.createElement(name))
    line.className = 'line'
    line.style.borderTopStyle = strokeOf(k).stroke[0]
    line.style.borderTopColor = `var(${strokeOf(k).paint})`
    code.textContent = relation
    item.append(line, code)
    return item
  }))
  return [...said, integrals ? ' errors of the relations of the lift:' : 'Errors of the relations of the lift along the first orbit:', list]
}

// Moves a first point to where the pointer is in the plane of the axes.
function put(index, [x, y]) {
  const coordinates = state.at[index].split(',')
  state.axes.forEach((name, k) => {
    const place = pointVariables().indexOf(name)
    if (place >= 0) coordinates[place] = decimal([x, y][k], 4)
  })
  state.at = state.at.toSpliced(index, 1, coordinates.join(','))
  chosen.at = true
  isFromGallery = false
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
    if (!by || !frame || !sheetOf) return
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
  $('gallery').onchange = ({ target: { value } }) => choose(value.startsWith('#') ? CLASSICAL[value.slice(1)] : value ? { system: value } : { field: state.field, lift: state.lift })
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
  $('field').oninput = typed
  $('lift').onclick = () => {
    isLifting = true
    if (isFromGallery) [state.eps, state.at, state.axes, chosen] = ['', [], [], { eps: false, at: false }]
    lift('automatic')
  }
  $('unlift').onclick = () => { lift(''); $('field').focus() }
  $('which-lift').replaceChildren(...Object.entries(LIFTS).map(([name, meaning]) => new Option(meaning, name)))
  $('which-lift').onchange = ({ target: { value } }) => lift(value)
  $('jacobian').ontoggle = () => { if ($('jacobian').open && sheetOf) jacobian() }
  for (const made of document.querySelectorAll('[data-copy]')) made.onclick = () => copy(made.dataset.copy, made)
  for (const made of document.querySelectorAll('[data-found]')) made.onclick = () => copyFound(made.dataset.found)
  $('search').onclick = search
  $('heights').onclick = () => long('heights', { ask: 'heights', eps: state.eps, at: state.at.at(-1)?.split(',') || [], steps: 60, digits: 20000, seconds: 10 }, ({ answer, html }) => {
    set('heights-shown', html)
    $('heights-stage').textContent = `Growth is ${answer.growth}, over ${answer.steps} steps.`
  })
  $('poles').onclick = () => long('poles', { ask: 'poles', seconds: 20 }, ({ html, answer }) => {
    set('poles-shown', html)
    $('poles-stage').textContent = `The degrees of the iterates are ${answer.degrees.join(', ')}: growth is ${answer.growth}.`
  })
  const timed = eps => { [state.eps, chosen.eps, isFromGallery] = [eps, true, false]; fields(); move() }
  $('slider').oninput = () => timed(ofSlider($('slider').value))
  $('eps').oninput = () => { if (NUMBER.test($('eps').value)) timed($('eps').value) }
  $('at').onchange = () => {
    const parts = $('at').value.split(',').map(part => part.trim())
    if (!sheetOf || parts.length !== pointVariables().length || !parts.every(part => NUMBER.test(part))) return
    state.at = [...state.at.slice(0, -1), parts.join(',')]
    chosen.at = true
    isFromGallery = false
    frame = null
    move()
  }
  $('steps').onchange = () => { state.steps = Math.min(1e6, Math.max(1, Math.round($('steps').value) || 1)); $('steps').value = state.steps; frame = null; move() }
  for (const [id, k] of [['across', 0], ['upwards', 1]]) $(id).onchange = () => { state.axes = state.axes.with(k, $(id).value); frame = null; save(); show(lastDrawn) }
  $('methods').replaceChildren(...Object.entries(METHODS).map(([name, [called, paint]]) => {
    const label = document.createElement('label')
    const box = Object.assign(document.createElement('input'), { type: 'checkbox', value: name, disabled: name === 'kahan' })
    box.onchange = () => { state.beside = [...$('methods').querySelectorAll('input')].filter(({ checked, disabled }) => checked && !disabled).map(({ value }) => value); frame = null; move() }
    const dot = Object.assign(document.createElement('span'), { className: 'dot' })
    dot.style.background = `var(${paint})`
    label.append(box, dot, called)
    return label
  }))
  $('fewer').onclick = () => { state.at = state.at.slice(0, 1); frame = null; fields(); move() }
  $('whole').onclick = () => { frame = { isWhole: true }; show(lastDrawn) }
  $('link').onclick = () => { save(); copied('linked', 'the link', location.href) }
  dragging()
  const again = () => { if (sheetOf) show(lastDrawn) }
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again)
  addEventListener('resize', again)
  addEventListener('hashchange', () => { isFromGallery = !location.hash; state = readAddress(); open() })
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
