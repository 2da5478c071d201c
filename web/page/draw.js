// Orbits and drifts on canvases: points become pixels of an image, words and rules are drawn over
// it.
const METHODS = { kahan: ['Kahan’s map', '--c1'], euler: ['Euler', '--c3'], rk4: ['Runge–Kutta 4', '--c2'], flow: ['the flow itself', '--c6'] }
const MARGIN = { left: 58, right: 12, top: 12, bottom: 40 }

const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim()
const numbers = hex => [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16))
const short = number => String(Number(number.toPrecision(4))).replace('-', '−').replace(/e\+?(.*)/, (_, power) => `·10${raised(power)}`)
const raised = power => String(power).replace(/[-−]/, '⁻').replace(/\d/g, digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit])

// The pixels of a canvas at the size that it has on the screen, and the scales of its axes.
function sheet(canvas, window) {
  const ratio = devicePixelRatio || 1
  const [width, height] = [canvas.clientWidth, canvas.clientHeight]
  canvas.width = Math.round(width * ratio)
  canvas.height = Math.round(height * ratio)
  const [[left, right], [low, high]] = window
  const across = (width - MARGIN.left - MARGIN.right) / (right - left)
  const upwards = (height - MARGIN.top - MARGIN.bottom) / (high - low)
  return {
    ratio, width, height, window,
    context: canvas.getContext('2d'),
    x: value => MARGIN.left + (value - left) * across,
    y: value => height - MARGIN.bottom - (value - low) * upwards,
    point: (x, y) => [left + (x - MARGIN.left) / across, low + (height - MARGIN.bottom - y) / upwards],
  }
}

// Round numbers between two ends, about so many.
function ticks([low, high], count) {
  const rough = (high - low) / count
  const power = 10 ** Math.floor(Math.log10(rough))
  const step = power * [1, 2, 5, 10].find(times => times * power >= rough)
  const first = Math.ceil(low / step)
  return Array.from({ length: Math.max(0, Math.floor(high / step) - first + 1) }, (_, k) => (first + k) * step)
}

// Rules, numbers and names of the axes.
function axes({ context, ratio, width, height, window, x, y }, names, written = short) {
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
    // A number at the edge is written inside.
    context.fillText(short(tick), Math.min(x(tick), width - context.measureText(short(tick)).width / 2), bottom + 17)
  }
  context.textAlign = 'right'
  for (const tick of ticks(window[1], height / 70)) {
    line([MARGIN.left, y(tick)], [right, y(tick)])
    context.fillText(written(tick), MARGIN.left - 6, y(tick) + 4)
  }
  context.fillStyle = colour('--ink')
  context.fillText(names[0], right, height - 6)
  context.textAlign = 'left'
  context.fillText(names[1], 4, MARGIN.top + 2)
}

// Draws points as squares that are the smaller the more there are, and wider by so many pixels as
// their set says.
function points(sheet, sets) {
  const { context, ratio, x, y } = sheet
  const { width, height } = context.canvas
  const image = context.createImageData(width, height)
  const pixels = new Uint32Array(image.data.buffer)
  const [zeroX, zeroY] = [x(0) * ratio, y(0) * ratio]
  const [perX, perY] = [x(1) * ratio - zeroX, y(1) * ratio - zeroY]
  const [left, right] = [MARGIN.left * ratio, width - MARGIN.right * ratio]
  const [top, bottom] = [MARGIN.top * ratio, height - MARGIN.bottom * ratio]
  for (const { xs, ys, paint, wider } of sets) {
    const [red, green, blue] = numbers(colour(paint))
    const word = (255 << 24) | (blue << 16) | (green << 8) | red
    const size = Math.max(1, Math.round(((xs.length <= 400 ? 4 : xs.length <= 50000 ? 1.6 : 1) + wider) * ratio))
    const back = (size - 1) / 2
    for (let k = 0; k < xs.length; k++) {
      const [px, py] = [zeroX + xs[k] * perX - back, zeroY + ys[k] * perY - back]
      // What is not a number is outside, too.
      if (!(px >= left && px < right - size && py >= top && py < bottom - size)) continue
      const at = Math.round(py) * width + Math.round(px)
      for (let row = at; row < at + size * width; row += width) {
        for (let pixel = row; pixel < row + size; pixel++) pixels[pixel] = word
      }
    }
  }
  context.putImageData(image, 0, 0)
}

// The portrait of orbits, a ring at each first point; the sheet tells where a pointer is.
function portrait(canvas, window, names, sets, starts) {
  const drawn = sheet(canvas, window)
  points(drawn, sets)
  // The points are above the rules.
  drawn.context.globalCompositeOperation = 'destination-over'
  axes(drawn, names)
  drawn.context.globalCompositeOperation = 'source-over'
  drawn.context.lineWidth = 2
  drawn.context.strokeStyle = colour('--ink')
  for (const [x, y] of starts) {
    drawn.context.beginPath()
    drawn.context.arc(drawn.x(x), drawn.y(y), 6, 0, 7)
    drawn.context.stroke()
  }
  return drawn
}

// Nearly all of these numbers, or all of them between two ends, with some room.
function span(lists, isWhole, [least, most] = [-Infinity, Infinity]) {
  const values = []
  for (const list of lists) {
    const stride = isWhole ? 1 : Math.ceil(list.length / 4000)
    for (let k = 0; k < list.length; k += stride) if (Number.isFinite(list[k]) && list[k] >= least && list[k] <= most) values.push(list[k])
  }
  values.sort((a, b) => a - b)
  const share = isWhole ? 0 : 0.005
  const [low, high] = [share, 1 - share].map(at => values[Math.round(at * (values.length - 1))] ?? 0)
  const room = 0.08 * (high - low) || Math.abs(low) / 10 || 1
  return [low - room, high + room]
}

// Strokes of relations, which tell them apart from integrals.
const RELATION_PAINTS = ['--c4', '--c5', '--c2', '--c3', '--c6', '--c1']
const STROKES = [['dashed', [7, 4]], ['dotted', [2, 3]]]
const strokeOf = k => ({ paint: RELATION_PAINTS[k % 6], stroke: STROKES[Math.floor(k / 6) % 2] })

// By how much integrals change: the logarithm of the largest relative change in each pixel. Of a
// relation the errors are known, in equal parts of an orbit that takes all steps.
function drift(canvas, time, orbits, relations, whole) {
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
  axes(drawn, ['t', ''], tick => (Number.isInteger(tick) ? `10${raised(tick)}` : ''))
  for (const { paint, stroke, heights } of curves) {
    drawn.context.strokeStyle = colour(paint)
    drawn.context.lineWidth = 1.6
    drawn.context.setLineDash(stroke?.[1] || [])
    drawn.context.beginPath()
    for (const [t, height] of heights) drawn.context.lineTo(drawn.x(t), Math.max(MARGIN.top, drawn.y(height)))
    drawn.context.stroke()
  }
  drawn.context.setLineDash([])
}
