// Draws orbits of three variables in a box that the user can turn, in parallel projection.

const isSpace = () => state.axes.length === 3

// Returns the projection of points of the box to the screen. The viewer's direction has the angle
// `about` around the third axis, and `above` over the plane of the first two axes, in radians.
function seenFrom([about, above], box) {
  const [cosA, sinA, cosE, sinE] = [Math.cos(about), Math.sin(about), Math.cos(above), Math.sin(above)]
  const scales = box.map(([low, high]) => [(low + high) / 2, 2 / Math.sqrt(3) / (high - low)])
  return point => {
    const [u, v, w] = point.map((value, k) => (value - scales[k][0]) * scales[k][1])
    return [v * cosA - u * sinA, w * cosE - (u * cosA + v * sinA) * sinE]
  }
}

// Returns the ranges of the screen that show the whole box, with equal scales on both axes.
function wholeBox({ clientWidth, clientHeight }) {
  const wide = (clientWidth - MARGIN.left - MARGIN.right) / (clientHeight - MARGIN.top - MARGIN.bottom)
  return [[-wide, wide], [-1, 1]].map(ends => ends.map(end => 0.92 * end))
}

// Returns the screen coordinates of the first `count` points of an orbit.
function seenPoints(columns, places, count, see) {
  const [xs, ys] = [new Float64Array(count), new Float64Array(count)]
  const [us, vs, ws] = places.map(k => columns[k])
  for (let k = 0; k < count; k++) [xs[k], ys[k]] = see([us[k], vs[k], ws[k]])
  return { xs, ys }
}

// Draws the edges of the box, and writes the names and ranges of the axes along three edges.
function edges({ context, ratio, x, y }, names, box, see) {
  context.setTransform(ratio, 0, 0, ratio, 0, 0)
  context.font = '13px system-ui, sans-serif'
  context.lineWidth = 1
  context.strokeStyle = colour('--rule')
  const corner = bits => see(box.map((ends, k) => ends[bits >> k & 1]))
  context.beginPath()
  for (let bits = 0; bits < 8; bits++) {
    for (const k of [0, 1, 2]) {
      if (bits >> k & 1) continue
      for (const [at, end] of [corner(bits), corner(bits | 1 << k)].entries()) context[at ? 'lineTo' : 'moveTo'](x(end[0]), y(end[1]))
    }
  }
  context.stroke()
  context.textAlign = 'center'
  names.forEach((name, k) => {
    // Chooses the lowest edge along axis k, or the leftmost edge along the upright axis.
    const beside = [0, 1, 2, 3, 4, 5, 6, 7].filter(bits => !(bits >> k & 1))
    const least = bits => corner(bits)[k === 2 ? 0 : 1] + corner(bits | 1 << k)[k === 2 ? 0 : 1]
    const bits = beside.reduce((one, other) => (least(other) < least(one) ? other : one))
    const [from, to] = [corner(bits), corner(bits | 1 << k)]
    const write = (text, share, paint) => {
      context.fillStyle = colour(paint)
      context.fillText(text, x(from[0] + (to[0] - from[0]) * share), y(from[1] + (to[1] - from[1]) * share) + 4)
    }
    write(name, 0.5, '--ink')
    write(short(box[k][0]), 0.12, '--soft')
    write(short(box[k][1]), 0.9, '--soft')
  })
}

// Turns the box by `across` and `upwards` pixels, of which 120 make one radian.
function turn(across, upwards, act = 'turn') {
  const [about, above] = state.turn
  const half = Math.PI / 2
  state.turn = [(about - across / 120) % (2 * Math.PI), Math.min(half, Math.max(-half, above + upwards / 120))]
  look(state.view, act)
}
