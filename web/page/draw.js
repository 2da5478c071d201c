// Draws orbits on a canvas: writes points as pixels of an image, and draws lines and text with the
// methods of the canvas.
const METHODS = { kahan: ['Kahan’s map', '--c1'], euler: ['Euler', '--c3'], rk4: ['Runge–Kutta 4', '--c2'], flow: ['the flow itself', '--c6'] }
const MARGIN = { left: 58, right: 12, top: 12, bottom: 40 }
const NO_MARGIN = { left: 2, right: 2, top: 2, bottom: 2 }

// The colours of single orbits, which are visible on white and on black.
const PAINTS = ['#2a7fb8', '#d1495b', '#3a9a5b', '#b07d12', '#8a5fc0', '#0f9a9a', '#c2589a', '#7a8b2a', '#5a78d6', '#c86432', '#6f7f8f', '#a0522d']
const colour = name => (name.startsWith('#') ? name : getComputedStyle(document.documentElement).getPropertyValue(name).trim())
const numbers = hex => [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16))
const short = number => String(Number(number.toPrecision(4))).replace('-', '−').replace(/e\+?(.*)/, (_, power) => `·10${raised(power)}`)
const raised = power => String(power).replace(/[-−]/, '⁻').replace(/\d/g, digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit])

// Fits a canvas to its size on the screen; returns maps between coordinates and pixels.
function sheet(canvas, window, margin = MARGIN) {
  const ratio = devicePixelRatio || 1
  const [width, height] = [canvas.clientWidth, canvas.clientHeight]
  canvas.width = Math.round(width * ratio)
  canvas.height = Math.round(height * ratio)
  const [[left, right], [low, high]] = window
  const across = (width - margin.left - margin.right) / (right - left)
  const upwards = (height - margin.top - margin.bottom) / (high - low)
  return {
    ratio, width, height, window, margin,
    context: canvas.getContext('2d'),
    x: value => margin.left + (value - left) * across,
    y: value => height - margin.bottom - (value - low) * upwards,
    point: (x, y) => [left + (x - margin.left) / across, low + (height - margin.bottom - y) / upwards],
  }
}

// Returns about `count` equally spaced round numbers from `low` to `high`.
function ticks([low, high], count) {
  const rough = (high - low) / count
  const power = 10 ** Math.floor(Math.log10(rough))
  const step = power * [1, 2, 5, 10].find(times => times * power >= rough)
  const first = Math.ceil(low / step)
  return Array.from({ length: Math.max(0, Math.floor(high / step) - first + 1) }, (_, k) => (first + k) * step)
}

// Draws the grid lines, their numbers, and the names of both axes.
function axes({ context, ratio, width, height, window, x, y }, names, written = short, apart = 70) {
  context.setTransform(ratio, 0, 0, ratio, 0, 0)
  context.font = '13px system-ui, sans-serif'
  context.lineWidth = 1
  context.strokeStyle = colour('--rule')
  context.fillStyle = colour('--soft')
  const line = (...ends) => {
    context.beginPath()
    ends.forEach(([x, y]) => context.lineTo(Math.round(x) + 0.5, Math.round(y) + 0.5))
    context.stroke()
  }
  const [right, bottom] = [width - MARGIN.right, height - MARGIN.bottom]
  context.textAlign = 'center'
  for (const tick of ticks(window[0], width / 110)) {
    line([x(tick), MARGIN.top], [x(tick), bottom])
    // Moves a number at the right edge inside the canvas.
    context.fillText(short(tick), Math.min(x(tick), width - context.measureText(short(tick)).width / 2), bottom + 17)
  }
  context.textAlign = 'right'
  for (const tick of ticks(window[1], height / apart)) {
    line([MARGIN.left, y(tick)], [right, y(tick)])
    context.fillText(written(tick), MARGIN.left - 6, y(tick) + 4)
  }
  context.fillStyle = colour('--ink')
  context.fillText(names[0], right, height - 6)
  context.textAlign = 'left'
  context.fillText(names[1], 4, MARGIN.top + 2)
}

// Draws points as squares; a set with more points has smaller squares. The field `wider` of a set
// widens its squares by that number of pixels.
function points(sheet, sets) {
  const { context, ratio, x, y } = sheet
  if (context instanceof VectorCanvas) { squares(sheet, sets); return }
  const { width, height } = context.canvas
  const image = context.createImageData(width, height)
  const pixels = new Uint32Array(image.data.buffer)
  const [zeroX, zeroY] = [x(0) * ratio, y(0) * ratio]
  const [perX, perY] = [x(1) * ratio - zeroX, y(1) * ratio - zeroY]
  const [left, right] = [sheet.margin.left * ratio, width - sheet.margin.right * ratio]
  const [top, bottom] = [sheet.margin.top * ratio, height - sheet.margin.bottom * ratio]
  for (const { xs, ys, paint, wider } of sets) {
    const [red, green, blue] = numbers(colour(paint))
    const word = (255 << 24) | (blue << 16) | (green << 8) | red
    const size = Math.max(1, Math.round((sizeOf(xs.length) + wider) * ratio))
    const back = (size - 1) / 2
    for (let k = 0; k < xs.length; k++) {
      const [px, py] = [zeroX + xs[k] * perX - back, zeroY + ys[k] * perY - back]
      // Skips points outside the frame, and also NaN, for which each comparison is false.
      if (!(px >= left && px < right - size && py >= top && py < bottom - size)) continue
      const at = Math.round(py) * width + Math.round(px)
      for (let row = at; row < at + size * width; row += width) {
        for (let pixel = row; pixel < row + size; pixel++) pixels[pixel] = word
      }
    }
  }
  context.putImageData(image, 0, 0)
}

const sizeOf = count => (count <= 400 ? 4 : count <= 5000 ? 2 : count <= 50000 ? 1.6 : 1)

// Draws the points inside the frame as squares of an SVG.
function squares({ context, x, y, width, height, margin }, sets) {
  for (const { xs, ys, paint, wider } of sets) {
    const places = Array.from(xs, (value, k) => [x(value), y(ys[k])])
    const inside = places.filter(([px, py]) => px >= margin.left && px < width - margin.right && py >= margin.top && py < height - margin.bottom)
    context.squares(inside, sizeOf(xs.length) + wider, colour(paint))
  }
}

// Clips all drawing to the frame, until the caller restores the context.
function beginInside({ context, width, height }) {
  context.save()
  context.beginPath()
  context.rect(MARGIN.left, MARGIN.top, width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom)
  context.clip()
}

// The largest number of points of an orbit whose points are joined by lines.
const JOINED = 300

// Joins successive points of each short orbit by lines, inside the frame.
function joined(drawn, sets) {
  const { context, x, y } = drawn
  beginInside(drawn)
  context.globalAlpha = 0.45
  context.lineWidth = 1
  for (const { xs, ys, paint, isSection } of sets) {
    if (isSection || xs.length > JOINED) continue
    context.strokeStyle = colour(paint)
    context.beginPath()
    for (let k = 0; k < xs.length; k++) if (Math.abs(xs[k]) + Math.abs(ys[k]) < 1e100) context.lineTo(x(xs[k]), y(ys[k]))
    context.stroke()
  }
  context.restore()
}

// Draws the orbits, and a ring at each first point, in a colour from `rings`. Fills the ring of the
// picked orbit, and draws this ring last. Returns the sheet of the canvas.
function portrait(canvas, window, drawAxes, sets, starts, picked, rings) {
  const drawn = sheet(canvas, window)
  points(drawn, sets)
  // Draws the grid lines below the points.
  drawn.context.globalCompositeOperation = 'destination-over'
  drawAxes(drawn)
  drawn.context.globalCompositeOperation = 'source-over'
  joined(drawn, sets)
  drawn.context.lineWidth = 2
  const inOrder = [...starts.keys()].sort((one, other) => (one === picked) - (other === picked))
  for (const k of inOrder) {
    const [px, py] = [drawn.x(starts[k][0]), drawn.y(starts[k][1])]
    if (px < MARGIN.left || px > drawn.width - MARGIN.right || py < MARGIN.top || py > drawn.height - MARGIN.bottom) continue
    drawn.context.beginPath()
    drawn.context.arc(px, py, 6, 0, 7)
    drawn.context.strokeStyle = colour(rings[k])
    drawn.context.fillStyle = colour(k === picked ? rings[k] : '--paper')
    drawn.context.fill()
    drawn.context.stroke()
  }
  return drawn
}

// Returns the range of the values from `least` to `most`, without a share of them at either end.
function span(lists, [least, most], share) {
  const values = []
  for (const list of lists) {
    const stride = Math.ceil(list.length / 4000)
    for (let k = 0; k < list.length; k += stride) if (Number.isFinite(list[k]) && list[k] >= least && list[k] <= most) values.push(list[k])
  }
  values.sort((a, b) => a - b)
  return [share, 1 - share].map(at => values[Math.round(at * (values.length - 1))] ?? 0)
}
