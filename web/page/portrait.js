// Draws the portrait, which is the main picture with the orbits, and handles its controls.
let frame = null // the drawn portrait: its sheet, its visible ranges and its first points
let lastDrawn = []
let relationErrors = [] // the errors of a lift's relations along the picked orbit

async function orbitsAnew() {
  const variables = pointVariables()
  const own = sheetOf
  const fits = state.at.length && state.at.every(at => at.split(',').length === variables.length && at.split(',').every(part => NUMBER.test(part)))
  const isBare = sheetOf.parameters.some(name => !(name in values) && !(name in state.shows))
  if (!chosen.eps || !chosen.at || !fits || isBare) {
    const scene = await lead.ask(pictured(subject()), { ask: 'scene' })
    if (!scene || sheetOf !== own) return
    if (scene.mistake) { undrawn(scene.mistake); return }
    state.shows = { ...scene.answer.values, ...state.shows }
    if (!chosen.eps) state.eps = decimal(valueOf(scene.answer.eps))
    if (!chosen.at || !fits) [state.at, state.picked, state.axes] = [scene.answer.at, 0, state.axes.length ? state.axes : scene.answer.axes]
    chosen = { eps: true, at: true }
    parameters(sheetOf.parameters)
  }
  if (!state.axes.every((name, k) => name === 't' && k < 2 || variables.includes(name)) || state.axes.length < 2 || state.axes.length > 3) {
    state.axes = variables.length > 1 ? variables.slice(0, 2) : ['t', variables[0]]
  }
  state.picked = Math.min(state.picked, state.at.length - 1)
  for (const [k, id] of AXES.entries()) $(id).replaceChildren(...[k < 2 ? 't' : '', ...variables].map(name => new Option(name || 'none', name)))
  $('third').hidden = variables.length < 3
  $('crossed').replaceChildren(...['', ...variables].map(name => new Option(name || 'none', name)))
  fitted = null
  fields()
  await move()
  if (sheetOf === own) searchFirst()
}

// Hides the picture, and says why the page cannot draw the orbits.
function undrawn(mistake) {
  say('ended', mistake)
  lastDrawn = []
  $('panes').hidden = true
}

// Returns ε for a position of the slider: 10⁻⁴ at the position 0, and 1 at the position 400.
const ofSlider = place => decimal(10 ** (place / 100 - 4))

function fields() {
  const eps = valueOf(state.eps)
  const put = (id, value) => { if (document.activeElement !== $(id)) $(id).value = value }
  put('eps', state.eps)
  const [crossed = '', level] = state.section
  $('crossed').value = crossed
  if (crossed) put('level', level)
  $('section').hidden = !crossed && pointVariables().length < 3
  put('at', state.at[state.picked] || '')
  put('slider', Math.round(100 * (Math.log10(Math.abs(eps)) + 4)))
  $('slider').setAttribute('aria-valuetext', `ε = ${state.eps}, Δt = ${short(2 * eps)}`)
  $('dt').textContent = `Δt = 2ε = ${short(2 * eps)}`
  $('pick').replaceChildren(...state.at.map((at, k) => new Option(`${k + 1} of ${state.at.length}`, k, false, k === state.picked)))
  $('delete').disabled = state.at.length < 2
  for (const [k, id] of AXES.entries()) $(id).value = state.axes[k] ?? ''
  $('turning').hidden = !isSpace()
  $('ranges').hidden = isSpace()
  $('turn').value = Math.round(state.turn[0] * 180 / Math.PI)
  for (const box of $('methods').querySelectorAll('input')) box.checked = box.value === 'kahan' || state.beside.includes(box.value)
  for (const box of $('overlays').querySelectorAll('input')) box.checked = state.over.includes(box.value)
}

// Returns a function that runs `work`; all calls during a run cause one more run.
function merged(work) {
  let [isBusy, isOvertaken] = [false, false]
  return async () => {
    isOvertaken = isBusy
    if (isBusy) return
    isBusy = true
    try {
      do {
        isOvertaken = false
        await work()
      } while (isOvertaken)
    } finally {
      isBusy = false
    }
  }
}

// Computes and draws the orbits of the current state; the flow follows later, because it is slower.
const [moveMaps, moveFlow] = [merged(() => orbits(mover, ['kahan', ...state.beside.filter(name => name !== 'flow')])), merged(() => orbits(follower, ['flow']))]
function move() {
  save()
  if (!sheetOf || !state.at.length) return undefined
  if (state.beside.includes('flow')) moveFlow()
  return moveMaps()
}

async function relations(asked) {
  const [{ at, picked, eps, steps }, names] = [state, lifted?.relations || []]
  if (!names.length) return []
  const reply = await mover.ask(asked, { ask: 'relations', eps, at: at[picked].split(','), steps })
  if (!reply || reply.mistake) return reply && []
  const { rows } = reply.answer
  return names.map((_, k) => reply.columns.subarray(k * rows, (k + 1) * rows))
}

// The largest number of steps of the flow, which takes longer to compute than the maps.
const FLOW_STEPS = 2000

const orbitFrom = (at, method, eps) => ({ ask: 'orbit', eps, at: at.split(','), steps: method === 'flow' ? Math.min(state.steps, FLOW_STEPS) : state.steps, method })

// Computes orbits by Kahan's map from all first points, and by other methods from the picked point.
async function orbits(asker, methods) {
  const [sheet, asked, { at: starts, picked, eps }] = [sheetOf, measured(), state]
  const made = []
  for (const method of methods) {
    for (const at of method === 'kahan' ? starts : starts.slice(picked, picked + 1)) {
      const reply = await asker.ask(asked, orbitFrom(at, method, eps))
      if (!reply || sheet !== sheetOf) return
      // Tries again without the integrals found, because one may be undefined along the orbit.
      if (reply.mistake && searched?.integrals?.length) { searched.integrals = []; return orbits(asker, methods) }
      if (reply.mistake) { undrawn(reply.mistake); return }
      const { head, rows, stopped, note } = reply.answer
      const columns = head.columns.map((_, k) => reply.columns.subarray(k * rows, (k + 1) * rows))
      const first = 2 + head.variables.length
      const crossings = method === 'kahan' ? crossingsOf(columns) : null
      const orbit = { names: head.columns, method, eps, at, columns, stopped, note, integrals: head.columns.map((_, k) => k).slice(first), crossings, paint: METHODS[method][1] }
      made.push({ ...orbit, escaped: escapeOf(orbit) })
    }
  }
  if (asker === mover) {
    const errors = await relations(asked)
    if (!errors || sheet !== sheetOf) return
    relationErrors = errors
  }
  const others = lastDrawn.filter(({ method }) => (method === 'flow') !== (asker === follower))
  const drawn = asker === follower ? [...others, ...made] : [...made, ...others]
  // Removes a flow with another first point or another ε.
  show(drawn.filter(({ method, eps, at }) => method !== 'flow' || state.beside.includes(method) && eps === state.eps && state.at[state.picked] === at))
}

// Returns the columns of the points at which the orbit crosses the section upwards, by linear
// interpolation between two steps; returns null without a section.
function crossingsOf(columns) {
  const [name, level] = state.section
  const place = 2 + pointVariables().indexOf(name)
  if (place < 2) return null
  const heights = columns[place].map(value => value - valueOf(level))
  const rows = []
  for (let k = 1; k < heights.length; k++) if (heights[k - 1] < 0 && heights[k] >= 0) rows.push(k)
  return columns.map(column => Float64Array.from(rows, k => column[k - 1] + (column[k] - column[k - 1]) * heights[k - 1] / (heights[k - 1] - heights[k])))
}

const placesOf = () => state.axes.map(name => (name === 't' ? 1 : 2 + pointVariables().indexOf(name)))

function show(drawn) {
  lastDrawn = drawn
  const own = drawn.filter(({ method }) => method === 'kahan')
  if (!own.length) return
  $('panes').hidden = false
  fitted ||= fit(placesOf())
  legend(own)
  drawPortrait()
  drawDrift()
}

// Writes the legend: the number of points, the orbits that escape, and notes.
function legend(own) {
  const parts = [`${own.length * (state.steps + 1)} points of ${own.length === 1 ? 'one orbit' : `${own.length} orbits`}`]
  const crossed = own.filter(({ crossings }) => crossings)
  if (crossed.length) parts.push(`${crossed.reduce((sum, { crossings }) => sum + crossings[0].length, 0)} crossings of the section are shown`)
  own.forEach(({ escaped }, k) => {
    if (escaped !== null) parts.push(`${own.length > 1 ? `Orbit ${k + 1}` : 'It'} escapes after ${escaped} steps`)
  })
  for (const { method, escaped } of lastDrawn) {
    if (method !== 'kahan' && escaped !== null) parts.push(`${METHODS[method][0]} blows up after ${escaped} steps`)
  }
  if (state.beside.includes('flow') && state.steps > FLOW_STEPS) parts.push(`The flow is drawn until t = ${short(2 * valueOf(state.eps) * FLOW_STEPS)}, its first ${FLOW_STEPS} steps`)
  const noted = own.find(({ note }) => note)
  if (noted) parts.push(`Note: ${noted.note}`)
  $('ended').textContent = `${parts.join('. ')}.`
}

// Draws the orbits that are already computed, with the current view and overlays.
function drawPortrait(canvas = $('portrait')) {
  const own = lastDrawn.filter(({ method }) => method === 'kahan')
  // Returns early without orbits, or if the picture is hidden and so has no width.
  if (!own.length || !$('portrait').clientWidth) return
  const places = placesOf()
  const see = isSpace() ? seenFrom(state.turn, fitted) : point => point
  const window = state.view || (isSpace() ? wholeBox(canvas) : fitted)
  const starts = state.at.map(at => state.axes.map(name => (name === 't' ? 0 : valueOf(at.split(',')[pointVariables().indexOf(name)])))).map(see)
  // Kahan's map is drawn above the other methods, whose points are wider.
  const isColoured = state.over.includes('colours') && own.length > 1
  // Each first point has a ring, even before its orbit is computed.
  const rings = state.at.map((_, k) => (isColoured ? PAINTS[k % PAINTS.length] : '--ink'))
  const isSection = own.some(({ crossings }) => crossings)
  const sets = lastDrawn.filter(({ crossings }) => crossings || !isSection).map(({ columns: all, crossings, paint, method, at }, k) => {
    const columns = crossings || all
    const count = crossings ? crossings[0].length : shownRows(all[0].length)
    const isPicked = method === 'kahan' && at === state.at[state.picked] && own.length > 1
    const seen = isSpace() ? seenPoints(columns, places, count, see) : { xs: columns[places[0]].subarray(0, count), ys: columns[places[1]].subarray(0, count) }
    return { ...seen, isSection, paint: isColoured && method === 'kahan' && rings[k] || paint, wider: isPicked ? 0.6 : { kahan: 0, flow: 2 }[method] ?? 0.8 }
  }).reverse()
  const drawn = { ...portrait(canvas, window, it => (isSpace() ? edges(it, state.axes, fitted, see) : axes(it, state.axes)), sets, starts, state.picked, rings), starts, window }
  drawPlane(drawn)
  if (canvas !== $('portrait')) return
  frame = drawn
  const label = `${isSpace() ? `${state.axes.join(', ')} in space` : `${state.axes[1]} against ${state.axes[0]}`} on ${own.length} orbits of ${state.steps} steps from ${state.at.join('; ')} at eps ${state.eps}`
  $('portrait').setAttribute('aria-label', label)
  window.forEach((ends, k) => ends.forEach((end, j) => { if (document.activeElement !== rangeInputs()[2 * k + j]) rangeInputs()[2 * k + j].value = decimal(end, 4) }))
}

// The ids of the menus for the axes.
const AXES = ['across', 'upwards', 'inwards']
const rangeInputs = () => $('ranges').querySelectorAll('input')

// Moves a first point to the coordinates [x, y] in the plane of the axes.
function put(index, [x, y], act) {
  const coordinates = state.at[index].split(',')
  state.axes.forEach((name, k) => {
    const place = pointVariables().indexOf(name)
    if (place >= 0) coordinates[place] = decimal([x, y][k], 4)
  })
  state.at = state.at.toSpliced(index, 1, coordinates.join(','))
  chosen = { eps: true, at: true }
  save(act)
  fields()
  move()
}

// Adds an orbit from a point of the picture, and picks this orbit.
function add(point) {
  if (state.at.length >= MOST_ORBITS) { $('refused').textContent = `${MOST_ORBITS} orbits are the most; delete one first.`; return }
  state.at = [...state.at, state.at[state.picked]]
  state.picked = state.at.length - 1
  put(state.picked, point, `add ${state.at.length}`)
}

function pick(index) {
  state.picked = (index + state.at.length) % state.at.length
  fields()
  move()
}

function deleteOrbit() {
  if (state.at.length < 2) return
  state.at = state.at.toSpliced(state.picked, 1)
  state.picked = Math.min(state.picked, state.at.length - 1)
  chosen = { eps: true, at: true }
  $('refused').textContent = ''
  save(`delete ${state.at.length}`)
  fields()
  move()
}

function wirePortrait() {
  const timed = eps => {
    ;[state.eps, chosen.eps, chosen.at] = [eps, true, true]
    save('eps')
    fields()
    move()
  }
  $('slider').oninput = () => { checked($('eps'), true); timed(ofSlider($('slider').value)) }
  $('eps').oninput = () => { if (NUMBER.test($('eps').value.trim()) && valueOf($('eps').value.trim())) { checked($('eps'), true); timed($('eps').value.trim()) } }
  $('eps').onchange = () => { checked($('eps'), NUMBER.test($('eps').value.trim()) && valueOf($('eps').value.trim()) !== 0, `ε = ${$('eps').value}`) }
  $('at').onchange = () => {
    if (!sheetOf) return
    const [parts, variables] = [$('at').value.split(',').map(part => part.trim()), pointVariables()]
    const wrong = parts.find(part => !NUMBER.test(part))
    $('at').setAttribute('aria-invalid', String(parts.length !== variables.length || wrong !== undefined))
    $('refused').textContent = parts.length !== variables.length
      ? `A first point has ${variables.length} numbers, ${variables.join(', ')}, with commas between them.`
      : wrong === undefined ? '' : `The first point has ${wrong || 'nothing'} where a number must stand, such as 0.15 or 3/20.`
    if ($('refused').textContent) return
    state.at = state.at.with(state.picked, parts.join(','))
    chosen = { eps: true, at: true }
    fitted = null
    save('at')
    move()
  }
  $('steps').onchange = () => {
    const asked = Math.round($('steps').value) || 1
    state.steps = Math.min(MOST_STEPS, Math.max(1, asked))
    $('refused').textContent = asked > MOST_STEPS ? `${MOST_STEPS} steps are the most.` : asked < 1 ? 'One step is the least.' : ''
    $('steps').value = state.steps
    fitted = null
    save('steps')
    move()
  }
  $('crossed').onchange = $('level').onchange = () => {
    const level = $('level').value.trim()
    if (!checked($('level'), NUMBER.test(level), level || 'Nothing')) return
    state.section = $('crossed').value ? [$('crossed').value, level] : []
    save('section')
    move()
  }
  for (const id of AXES) {
    $(id).onchange = () => {
      ;[state.axes, state.view, fitted] = [AXES.map(one => $(one).value).filter(Boolean), null, null]
      // Replaces the time as an axis of the box, or returns to a picture with two axes.
      if (isSpace() && state.axes.includes('t')) state.axes = id === 'inwards' ? [...pointVariables().filter(name => name !== state.axes[2]).slice(0, 2), state.axes[2]] : state.axes.slice(0, 2)
      save('axes')
      fields()
      show(lastDrawn)
    }
  }
  $('turn').oninput = () => { state.turn = [$('turn').value * Math.PI / 180, state.turn[1]]; look(state.view, 'turn') }
  rangeInputs().forEach((input, at) => {
    input.onchange = () => {
      const ends = [...rangeInputs()].map(({ value }) => valueOf(value.trim()))
      const isRight = NUMBER.test(input.value.trim()) && ends[0] < ends[1] && ends[2] < ends[3]
      input.setAttribute('aria-invalid', String(!isRight))
      $('refused').textContent = isRight ? '' : `The ${at < 2 ? 'range across' : 'range upwards'} needs two numbers, the smaller one first.`
      if (isRight) look([ends.slice(0, 2), ends.slice(2)], 'range')
    }
  })
  $('methods').replaceChildren(...Object.entries(METHODS).map(([name, [called, paint]]) => {
    const label = document.createElement('label')
    const box = Object.assign(document.createElement('input'), { type: 'checkbox', value: name, disabled: name === 'kahan' })
    box.onchange = () => {
      state.beside = [...$('methods').querySelectorAll('input')].filter(({ checked, disabled }) => checked && !disabled).map(({ value }) => value)
      save('methods')
      move()
    }
    const dot = Object.assign(document.createElement('span'), { className: 'dot' })
    dot.style.background = `var(${paint})`
    label.append(box, dot, called)
    return label
  }))
  $('pick').onchange = () => pick(Number($('pick').value))
  $('delete').onclick = deleteOrbit
  $('fit').onclick = fitAgain
  $('closer').onclick = () => zoom(0.7)
  $('wider').onclick = () => zoom(1 / 0.7)
  $('undo').onclick = () => history.back()
  $('redo').onclick = () => history.forward()
  addEventListener('keydown', event => {
    if (!(event.ctrlKey || event.metaKey) || /^(TEXTAREA|INPUT|SELECT)$/.test(event.target.tagName)) return
    const key = event.key.toLowerCase()
    if (key === 'z' && !event.shiftKey && visited.place > 0) history.back()
    else if (key === 'y' || key === 'z' && event.shiftKey) history.forward()
    else return
    event.preventDefault()
  })
  $('link').onclick = () => { save(); copied('linked', searched?.lines?.length ? 'the link, with what was found' : 'the link', linkWithFindings()) }
  $('png').onclick = () => $('portrait').toBlob(picture => download(picture, 'png'))
  $('svg').onclick = () => {
    const paper = new VectorCanvas($('portrait'))
    drawPortrait(paper)
    download(new Blob([paper.text()], { type: 'image/svg+xml' }), 'svg')
  }
  $('csv').onclick = () => download(new Blob([csv()], { type: 'text/csv' }), 'csv')
  pointers()
  const again = () => { if (sheetOf) show(lastDrawn) }
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again)
  new ResizeObserver(again).observe($('panes'))
}

function download(content, ending) {
  const link = Object.assign(document.createElement('a'), { href: URL.createObjectURL(content), download: `kahan.${ending}` })
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 1000)
}

// Returns the points of all computed orbits as CSV.
function csv() {
  const rows = lastDrawn.flatMap(({ method, at, names, columns }, k) => Array.from(columns[0], (_, row) => [k + 1, method, ...columns.slice(0, 2 + at.split(',').length).map(column => column[row])].join(',')))
  return [['orbit', 'method', ...lastDrawn[0].names.slice(0, 2 + lastDrawn[0].at.split(',').length)].join(','), ...rows, ''].join('\n')
}
