// Sets the view, which is the visible part of the plane, and handles pointers and keys.
let fitted = null // the view that fits the orbits, which applies while `state.view` is null

// The factor by which an orbit that escapes exceeds the size of its first point.
const REACH = 1e3

// Returns the last step before an orbit escapes for good or stops, or null if the orbit stays.
function escapeOf({ columns, at, stopped }) {
  const own = columns.slice(2, 2 + at.split(',').length)
  const size = REACH * (Math.max(...own.map(column => Math.abs(column[0]))) || 1)
  let last = own[0].length - 1
  // Treats NaN as out of reach, because each comparison with NaN is false.
  while (last >= 0 && !own.every(column => Math.abs(column[last]) <= size)) last--
  return last < own[0].length - 1 ? last : stopped ? stopped.step : null
}

// Returns the view that shows the orbits of the map that stay, or how all begin if none stays.
function fit(places) {
  const own = lastDrawn.filter(({ method }) => method === 'kahan')
  const stays = own.filter(({ escaped }) => escaped === null)
  // Leaves out each orbit that is more than three times as wide as the median orbit.
  const widths = stays.map(({ columns }) => Math.max(...places.filter(k => k !== 1).map(k => (([low, high]) => high - low)(span([columns[k]], [-Infinity, Infinity], 0.005)))))
  const usual = widths.toSorted((a, b) => a - b)[(widths.length - 1) >> 1]
  const staying = stays.filter((_, k) => widths[k] <= 3 * usual)
  return places.map(k => {
    const lists = (staying.length ? staying : own).map(({ columns }) => columns[k])
    const starts = lists.map(list => list[0])
    if (k === 1) return [Math.min(...lists.map(list => list.at(-1)), 0), Math.max(...lists.map(list => list.at(-1)), 0)]
    const size = Math.max(...starts.map(Math.abs)) || 1
    if (!staying.length) return span(lists, [-8 * size, 8 * size], 0)
    const [low, high] = span(lists, [-REACH * size, REACH * size], 0.005)
    // Adds the first 200 points, because an orbit that comes to rest soon leaves its beginning.
    const reach = 4 * Math.max(size, high - low)
    const early = lists.map(list => list.subarray(0, 200)).map(list => list.filter(value => value >= low - reach && value <= high + reach))
    return span([[low, high], ...early], [-Infinity, Infinity], 0)
  }).map(([low, high], k) => {
    const room = places[k] === 1 ? 0 : 0.06 * (high - low) || Math.abs(low) / 10 || 1
    return [low - room, high + room]
  })
}

// Sets the view, and draws the portrait in the next animation frame.
let isDrawing = false
function look(view, act) {
  state.view = view
  save(act)
  if (isDrawing) return
  isDrawing = true
  requestAnimationFrame(() => { isDrawing = false; drawPortrait() })
}

// Scales the ranges of the view by `times`; the point [px, py] of the canvas stays in its place.
function zoom(times, [px, py] = [frame.width / 2, frame.height / 2], act = 'zoom') {
  const point = frame.point(px, py)
  const view = (state.view || frame.window).map(([low, high], k) => [low, high].map(end => point[k] + (end - point[k]) * times))
  // Refuses ranges that are too narrow for the precision of floating-point numbers, or too wide.
  if (view.every(([low, high]) => high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high)) && high - low < 1e100)) look(view, act)
}

// Moves the view to the left by `across` pixels, and up by `upwards` pixels.
function pan(across, upwards, act = 'pan') {
  const by = [[frame.width, MARGIN.left + MARGIN.right, -across], [frame.height, MARGIN.top + MARGIN.bottom, upwards]]
  look((state.view || frame.window).map(([low, high], k) => {
    const [whole, margins, pixels] = by[k]
    const move = pixels * (high - low) / (whole - margins)
    return [low + move, high + move]
  }), act)
}

function fitAgain() {
  fitted = fit(placesOf())
  look(null, 'fit')
}

// One finger scrolls the page, and two fingers zoom. A mouse or pen moves the view or turns the
// box. In the plane, a click or tap adds an orbit, and a drag of a ring moves its first point.
function pointers() {
  const canvas = $('portrait')
  const down = new Map()
  let [held, hasMoved] = [-1, false]
  const place = ({ clientX, clientY }) => {
    const box = canvas.getBoundingClientRect()
    return [clientX - box.left, clientY - box.top]
  }
  const ringAt = ([px, py], reach) => {
    if (!frame || !sheetOf || isSpace()) return -1
    const far = frame.starts.map(([x, y]) => Math.hypot(frame.x(x) - px, frame.y(y) - py))
    const nearest = far.indexOf(Math.min(...far))
    return far[nearest] < reach ? nearest : -1
  }
  canvas.addEventListener('touchstart', event => {
    if (event.touches.length > 1 || ringAt(place(event.touches[0]), 22) >= 0) event.preventDefault()
  }, { passive: false })
  canvas.onpointerdown = event => {
    if (!frame || !sheetOf || event.button !== 0) return
    down.set(event.pointerId, place(event))
    hasMoved = down.size > 1
    held = down.size > 1 ? -1 : ringAt(place(event), event.pointerType === 'touch' ? 22 : 12)
    if (held >= 0 && held !== state.picked) pick(held)
    canvas.setPointerCapture(event.pointerId)
  }
  canvas.onpointermove = event => {
    if (frame && sheetOf) hover(place(event))
    const before = down.get(event.pointerId)
    if (!before) return
    const now = place(event)
    if (!hasMoved && Math.hypot(now[0] - before[0], now[1] - before[1]) < 4) return
    hasMoved = true
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1]
    down.set(event.pointerId, now)
    if (held >= 0) put(held, frame.point(...now), `drag ${held}`)
    else if (other) {
      const [was, is] = [before, now].map(([x, y]) => Math.hypot(x - other[0], y - other[1]))
      if (was > 0 && is > 0) zoom(was / is, other, 'pinch')
    } else if (event.pointerType !== 'touch') (isSpace() ? turn : pan)(now[0] - before[0], now[1] - before[1])
  }
  canvas.onpointerup = event => {
    if (!down.delete(event.pointerId)) return
    if (!hasMoved && held < 0 && frame && sheetOf && !isSpace()) add(frame.point(...place(event)))
    held = -1
  }
  canvas.onpointercancel = event => { down.delete(event.pointerId); held = -1 }
  canvas.onpointerleave = () => { $('where').textContent = '' }
  // The wheel zooms with Ctrl, which browsers also report for a touchpad pinch, or if the picture
  // has the focus. Otherwise, the wheel scrolls the page.
  canvas.addEventListener('wheel', event => {
    if (!frame || !(event.ctrlKey || event.metaKey || document.activeElement === canvas)) return
    event.preventDefault()
    zoom(2 ** (event.deltaY / (event.ctrlKey ? 100 : 400)), place(event))
  }, { passive: false })
  canvas.onkeydown = event => {
    if (!frame || !sheetOf || event.ctrlKey || event.metaKey || event.altKey) return
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key]
    const acts = {
      '+': () => zoom(0.8), '=': () => zoom(0.8), '-': () => zoom(1.25), 0: fitAgain,
      Delete: deleteOrbit, Backspace: deleteOrbit, '[': () => pick(state.picked - 1), ']': () => pick(state.picked + 1),
      Enter: () => !isSpace() && add(frame.starts[state.picked].map((value, k) => value + (frame.window[k][1] - frame.window[k][0]) / 25)),
    }
    if (by && isSpace()) turn(10 * by[0], 10 * by[1])
    else if (by && event.shiftKey) pan(-40 * by[0], 40 * by[1])
    else if (by) put(state.picked, frame.starts[state.picked].map((value, k) => value + by[k] * (frame.window[k][1] - frame.window[k][0]) / 50), `key ${state.picked}`)
    else if (acts[event.key]) acts[event.key]()
    else return
    event.preventDefault()
  }
}

// Shows the coordinates under the pointer, if the pointer is inside the frame.
function hover([px, py]) {
  const [x, y] = frame.point(px, py)
  const isInside = !isSpace() && x >= frame.window[0][0] && x <= frame.window[0][1] && y >= frame.window[1][0] && y <= frame.window[1][1]
  $('where').textContent = isInside ? `${state.axes[0]} = ${short(x)}, ${state.axes[1]} = ${short(y)}` : ''
}
