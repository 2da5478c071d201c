// Draws the plot under the portrait: the change of the integrals along the picked orbit, or one
// variable against the time if no integral is known. A slider sets the last time that is drawn.

// The colours and dashes of the curves of relations; the curves of integrals are solid.
const RELATION_PAINTS = ['--c4', '--c5', '--c2', '--c3', '--c6', '--c1']
const STROKES = [['dashed', [7, 4]], ['dotted', [2, 3]]]
const strokeOf = k => ({ paint: RELATION_PAINTS[k % 6], stroke: STROKES[Math.floor(k / 6) % 2] })

// Draws the base-10 logarithm of the integrals' largest relative change, pixel by pixel. Also draws
// the largest errors of relations, in equal parts of the time `whole`. Draws all curves up to
// `share` of the last time, where `share` is from 0 to 1.
function drift(canvas, time, orbits, relations, whole, share) {
  const FLOOR = -17
  const end = time.at(-1) || 1
  const curve = (sizes, style, end) => {
    const heights = Array.from(sizes, (size, k) => [(k / (sizes.length - 1)) * end, Math.max(FLOOR, Math.log10(size))])
    return { ...style, heights: heights.filter(([, height]) => height > FLOOR && height < 300) }
  }
  const ofIntegrals = orbits.map(({ columns, integrals, paint }) => {
    const bins = new Float64Array(Math.max(60, canvas.clientWidth - MARGIN.left)).fill(0)
    for (const values of integrals.map(index => columns[index])) {
      const size = Math.abs(values[0]) || 1
      for (let k = 0; k < values.length; k++) {
        const bin = Math.floor((k / Math.max(1, time.length - 1)) * (bins.length - 1))
        bins[bin] = Math.max(bins[bin], Math.abs(values[k] - values[0]) / size)
      }
    }
    return curve(bins, { paint }, end)
  })
  const curves = [...relations.map((sizes, k) => curve(sizes, strokeOf(k), whole)), ...ofIntegrals]
  const top = Math.max(-10, ...curves.flatMap(({ heights }) => heights.map(([, height]) => height)))
  const drawn = sheet(canvas, [[Math.min(0, end), Math.max(0, end)], [FLOOR, Math.min(top, 6) + 1]])
  axes(drawn, ['t', ''], tick => (Number.isInteger(tick) ? `10${raised(tick)}` : ''), 30)
  for (const { paint, stroke, heights } of curves) {
    path(drawn, heights.filter(([t]) => Math.abs(t) <= share * Math.abs(end)), paint, stroke?.[1])
  }
}

// The number of steps in the plot of a variable against the time.
const SERIES = 400

// Draws a variable against the time along orbits, up to the row `until` or to an escape.
function series(canvas, name, orbits, place, until) {
  const from = Math.max(0, until - SERIES)
  const parts = orbits.map(({ columns, paint, escaped }) => ({ paint, ts: columns[1].subarray(from, Math.max(until, from + 2)), values: columns[place].subarray(from, Math.min(until, (escaped ?? until) + 1)) }))
  const times = parts[0].ts
  const whole = Math.abs(times[1] - times[0]) * SERIES * Math.sign(times[1] - times[0] || 1)
  const [low, high] = span([parts[0].values], [-Infinity, Infinity], 0)
  const room = 0.3 * (high - low) || 1
  const drawn = sheet(canvas, [[Math.min(times[0], times[0] + whole), Math.max(times[0], times[0] + whole)], [low - room, high + room]])
  axes(drawn, ['t', name])
  for (const { paint, ts, values } of parts) path(drawn, Array.from(values, (value, k) => [ts[k], value]).filter(([, value]) => Math.abs(value) < 1e100), paint)
}

// Draws a line through points, inside the frame.
function path(drawn, points, paint, dashes = []) {
  const { context, x, y } = drawn
  beginInside(drawn)
  context.strokeStyle = colour(paint)
  context.lineWidth = 1.6
  context.setLineDash(dashes)
  context.beginPath()
  for (const [across, upwards] of points) context.lineTo(x(across), y(upwards))
  context.stroke()
  context.restore()
}

// Returns one orbit of each method from the picked first point, Kahan's map first.
const compared = () => lastDrawn.filter(({ at }) => at === state.at[state.picked]).filter(({ method }, k, all) => all.findIndex(other => other.method === method) === k)

function drawDrift() {
  const orbits = compared()
  const kahan = orbits.find(({ method }) => method === 'kahan')
  if (!kahan || !$('drift').clientWidth) return
  const measured = orbits.filter(({ integrals }) => integrals.length)
  const integrals = measured.length ? measured[0].integrals.map(k => measured[0].names[k]) : []
  $('seeing').textContent = seeing(orbits)
  const has = Boolean(measured.length || relationErrors.length)
  if (has) {
    $('drifting').replaceChildren(...drifting(integrals))
    $('drift').setAttribute('aria-label', ['Drift of', integrals.join(', ') || 'nothing', ...(relationErrors.length ? ['and errors of', lifted.relations.join('; ')] : [])].join(' '))
    drift($('drift'), kahan.columns[1], measured, relationErrors, 2 * valueOf(kahan.eps) * state.steps, shownRows(state.steps + 1) / (state.steps + 1))
    return
  }
  const name = state.axes.findLast(axis => axis !== 't')
  $('drifting').replaceChildren(`${name} against the time. ${unknown()}`)
  $('drift').setAttribute('aria-label', `${name} against the time from ${kahan.at}`)
  const count = played < 1 ? shownRows(state.steps + 1) : SERIES
  series($('drift'), name, orbits, 2 + pointVariables().indexOf(name), Math.min(Math.max(count, 2), kahan.columns[0].length))
}

// Returns a sentence that says why the plot shows no integral.
function unknown() {
  const lines = searched?.lines
  if (!lines) return `No integral is known yet: press “${$('search').textContent}” to search.`
  if (lines.some(line => line.startsWith('integral '))) return 'The integrals that were found have no value along this orbit.'
  return `The search found no integral${lines.length ? '; what it found stands under “What does it keep?”' : ''}.`
}

// Returns a description of the pictures: for each method, an escape or the change of the integrals.
function seeing(orbits) {
  const parts = orbits.filter(({ method }) => method !== 'flow').map(({ method, integrals, columns, escaped }) => {
    const called = METHODS[method][0]
    if (escaped !== null) return `${called} escapes after ${escaped} steps`
    if (!integrals.length) return ''
    const worst = Math.max(...integrals.map(k => {
      const [values, size] = [columns[k], Math.abs(columns[k][0]) || 1]
      return values.reduce((most, value) => Math.max(most, Math.abs(value - values[0]) / size), 0)
    }))
    const [what, again] = integrals.length > 1 ? [`the ${integrals.length} integrals`, 'them'] : ['the integral', 'it']
    return `${called} ${worst < 1e-8 ? `keeps ${what} to` : `changes ${method === 'kahan' ? what : again} by`} ${short(Number(worst.toPrecision(1)))}`
  }).filter(Boolean)
  const said = parts.length ? `${parts.join('; ')}, in ${state.steps} steps of Δt = ${short(2 * valueOf(state.eps))}.` : ''
  const own = CLASSICAL.find(({ field }) => field === state.field)
  return [own?.seen, said, 'Try: make ε larger, or drag a ring.'].filter(Boolean).join(' ')
}

// The largest number of characters of a formula in the caption of the plot.
const MOST_SHOWN = 240

// Returns the caption of the plot: the formulas of the integrals, and the relations of a lift.
function drifting(names) {
  const item = (text, stroke) => {
    const [made, line, code] = ['li', 'span', 'code'].map(name => document.createElement(name))
    code.textContent = text.length > MOST_SHOWN ? `${text.slice(0, MOST_SHOWN)}…` : text
    made.append(code)
    if (!stroke) return made
    line.className = 'line'
    Object.assign(line.style, { borderTopStyle: stroke.stroke[0], borderTopColor: `var(${stroke.paint})` })
    made.prepend(line)
    return made
  }
  const claims = sheetOf.claims.filter(({ kind, name }) => kind === 'integral' && names.includes(name)).map(({ statement }) => statement)
  const formulas = names.length ? (claims.length ? claims : searched?.integrals || []) : []
  const relations = relationErrors.length ? lifted.relations : []
  const list = document.createElement('ul')
  list.append(...formulas.map(text => item(text)), ...relations.map((text, k) => item(text, strokeOf(k))))
  const change = names.length ? [`the largest relative change of ${names.join(', ')}`] : []
  const errors = relations.length ? ['the errors of the relations of the lift'] : []
  return [`Along the picked orbit, ${[...change, ...errors].join(', and ')}${list.children.length ? ':' : '.'}`, list]
}

// --- The time up to which orbits are drawn

let played = 1 // the position of the time slider, from 0 to 1
let playing = 0 // the id of the next animation frame, or 0 during a pause

// Returns how many of `rows` rows are shown: few at first, so that single steps are visible.
const shownRows = rows => (played >= 1 ? rows : Math.max(2, Math.ceil(played ** 3 * rows)))

// The duration of the animation from the first step to the last, in milliseconds.
const PLAY = 10000

function playTo(place) {
  played = Math.min(1, place)
  $('time').value = Math.round(1000 * played)
  const t = 2 * valueOf(state.eps) * (shownRows(state.steps + 1) - 1)
  $('time').setAttribute('aria-valuetext', `t = ${short(t)}`)
  $('until').textContent = `t = ${short(t)}`
  if (!lastDrawn.length) return
  drawPortrait()
  drawDrift()
}

function pause() {
  cancelAnimationFrame(playing)
  playing = 0
  $('play').textContent = 'Play'
}

function play() {
  if (playing) { pause(); return }
  if (played >= 1) played = 0
  $('play').textContent = 'Pause'
  let last = performance.now()
  const next = now => {
    playTo(played + Math.max(0, now - last) / PLAY)
    last = now
    if (played < 1) playing = requestAnimationFrame(next)
    else pause()
  }
  playing = requestAnimationFrame(next)
}

function wireTime() {
  $('play').onclick = play
  $('time').oninput = () => { if (playing) pause(); playTo($('time').value / 1000) }
}
