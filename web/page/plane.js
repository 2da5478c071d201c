// Draws overlays of the portrait: directions of the field, nullclines, equilibria with eigenvalues
// of the Jacobian f′, and level curves of an integral through the first points.
const OVERLAYS = { directions: 'Direction field', nullclines: 'Nullclines', equilibria: 'Equilibria', levels: 'Level curves of an integral', colours: 'A colour for each orbit' }
const GRID = [72, 48]
// The distance between neighbouring arrows, in grid points.
const APART = 3

const inPlane = { key: '', isAsked: false, answer: null }

// Draws the overlays that the user has chosen. Asks the worker for new values if the field or the
// view has changed.
function drawPlane(drawn) {
  $('resting').replaceChildren()
  if (isSpace()) return
  const [isPlane, hasLevels] = [pointVariables().length === 2, state.over.includes('levels')]
  $('levelled').textContent = hasLevels && !isPlane ? 'Level curves are drawn of fields of two variables.' : ''
  if (!state.over.some(name => name !== 'colours') || state.axes.includes('t') || state.axes[0] === state.axes[1]) return
  const at = state.at[state.picked].split(',').map(valueOf)
  const axes = state.axes.map(name => pointVariables().indexOf(name))
  const asked = hasLevels && isPlane ? measured() : pictured(subject())
  const question = { ask: 'plane', at, axes, window: drawn.window, points: GRID, ...(hasLevels && isPlane && { orbit: { eps: state.eps, at: [], steps: 0 } }) }
  // Leaves coordinates along the axes out of the key, because the grid replaces these coordinates.
  const key = JSON.stringify([asked, { ...question, at: at.map((value, k) => (axes.includes(k) ? 0 : value)) }])
  if (key !== inPlane.key && !inPlane.isAsked) {
    inPlane.isAsked = true
    planner.ask(asked, question).then(reply => {
      Object.assign(inPlane, { key, isAsked: false, answer: reply && !reply.mistake ? { ...reply, window: drawn.window, axes } : null })
      drawPortrait()
    })
  }
  const { answer } = inPlane
  if (!answer || answer.axes.join() !== axes.join()) return
  const { context } = drawn
  beginInside(drawn)
  const [across, upwards] = GRID
  const [us, vs, ...integrals] = Array.from({ length: answer.columns.length / (across * upwards) }, (_, k) => answer.columns.subarray(k * across * upwards, (k + 1) * across * upwards))
  const place = ([column, row]) => [column, row].map((at, k) => answer.window[k][0] + (answer.window[k][1] - answer.window[k][0]) * (at + 0.5) / GRID[k])
  if (state.over.includes('directions')) arrows(drawn, us, vs, place)
  if (state.over.includes('nullclines')) {
    zeros(drawn, us, place, '--c4')
    zeros(drawn, vs, place, '--c5')
  }
  if (hasLevels && isPlane) levels(drawn, integrals[0], place)
  if (state.over.includes('equilibria')) resting(drawn, answer.answer.equilibria, axes)
  context.restore()
}

// Draws arrows of equal length in the direction of the field on the screen.
function arrows({ context, x, y }, us, vs, place) {
  const LENGTH = 14
  const [perX, perY] = [x(1) - x(0), y(1) - y(0)]
  context.strokeStyle = colour('--soft')
  context.globalAlpha = 0.7
  context.lineWidth = 1
  context.beginPath()
  for (let row = 1; row < GRID[1]; row += APART) {
    for (let column = 1; column < GRID[0]; column += APART) {
      const k = row * GRID[0] + column
      const [dx, dy] = [us[k] * perX, vs[k] * perY]
      const size = Math.hypot(dx, dy)
      if (!(size > 0 && size < Infinity)) continue
      const [px, py] = (([a, b]) => [x(a), y(b)])(place([column, row]))
      const [ux, uy] = [dx / size, dy / size]
      const [tipX, tipY] = [px + ux * LENGTH / 2, py + uy * LENGTH / 2]
      context.moveTo(px - ux * LENGTH / 2, py - uy * LENGTH / 2)
      context.lineTo(tipX, tipY)
      for (const side of [-1, 1]) {
        context.moveTo(tipX, tipY)
        context.lineTo(tipX - 4 * ux - 2.5 * side * uy, tipY - 4 * uy + 2.5 * side * ux)
      }
    }
  }
  context.stroke()
  context.globalAlpha = 1
}

// Draws the level curves of an integral through the first points of the orbits.
function levels(drawn, integral, place) {
  const own = lastDrawn.filter(({ method, integrals }) => method === 'kahan' && integrals.length)
  $('levelled').textContent = integral && own.length ? `Curves on which ${own[0].names[own[0].integrals[0]]} has the values of the first points.` : unknown()
  if (!integral) return
  for (const { columns, integrals } of own) zeros(drawn, integral.map(value => value - columns[integrals[0]][0]), place, '--soft')
}

// Draws the curves where values on the grid are 0: a segment in each triangle with both signs.
// Skips a change of sign at a pole, towards which the absolute values grow from both sides.
function zeros({ context, x, y }, values, place, paint) {
  context.strokeStyle = colour(paint)
  context.lineWidth = 1.6
  context.beginPath()
  const at = ([column, row]) => (column >= 0 && column < GRID[0] ? values[row * GRID[0] + column] : NaN)
  const beyond = (from, to) => Math.abs(at(to.map((value, k) => 2 * value - from[k])))
  for (let row = 0; row + 1 < GRID[1]; row++) {
    for (let column = 0; column + 1 < GRID[0]; column++) {
      const corners = [[column, row], [column + 1, row], [column + 1, row + 1], [column, row + 1]]
      for (const triangle of [[0, 1, 2], [0, 2, 3]]) {
        const ends = []
        triangle.forEach((from, k) => {
          const [one, other] = [corners[from], corners[triangle[(k + 1) % 3]]]
          const [before, after] = [at(one), at(other)]
          if (before < 0 === after < 0 || !Number.isFinite(before - after)) return
          if (Math.abs(before) > beyond(other, one) && Math.abs(after) > beyond(one, other)) return
          const share = before / (before - after)
          ends.push(place(one.map((value, axis) => value + share * (other[axis] - value))))
        })
        if (ends.length === 2) {
          context.moveTo(x(ends[0][0]), y(ends[0][1]))
          context.lineTo(x(ends[1][0]), y(ends[1][1]))
        }
      }
    }
  }
  context.stroke()
}

// Draws equilibria as squares, filled if all eigenvalues have real parts ≤ 0; lists eigenvalues.
function resting({ context, x, y }, equilibria, axes) {
  context.strokeStyle = colour('--ink')
  context.lineWidth = 2
  for (const { at, eigenvalues } of equilibria) {
    const [px, py] = [x(at[axes[0]]), y(at[axes[1]])]
    context.fillStyle = colour(eigenvalues.every(([real]) => real <= 1e-9) ? '--ink' : '--paper')
    context.beginPath()
    context.rect(px - 4, py - 4, 8, 8)
    context.fill()
    context.stroke()
  }
  const number = value => short(Math.abs(value) < 1e-12 ? 0 : value)
  const said = ([real, imaginary]) => (Math.abs(imaginary) < 1e-12 ? number(real) : `${Math.abs(real) < 1e-12 ? '' : `${number(real)} `}${imaginary < 0 ? '−' : '+'} ${number(Math.abs(imaginary))} i`)
  $('resting').replaceChildren(...equilibria.map(({ at, eigenvalues }) => {
    const item = document.createElement('li')
    item.textContent = `(${at.map(number).join(', ')}): eigenvalues ${eigenvalues.map(said).join(', ')}`
    return item
  }))
}

function wirePlane() {
  $('overlays').replaceChildren(...Object.entries(OVERLAYS).map(([name, called]) => {
    const label = document.createElement('label')
    const box = Object.assign(document.createElement('input'), { type: 'checkbox', value: name })
    box.onchange = () => {
      state.over = [...$('overlays').querySelectorAll('input')].filter(({ checked }) => checked).map(({ value }) => value)
      save('overlays')
      drawPortrait()
    }
    label.append(box, called)
    return label
  }))
}
