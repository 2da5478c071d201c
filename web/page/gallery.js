// Lists classical systems outside the catalog, each with a description, a source, equations and the
// initial state of its picture. The page opens with the first system. The last three systems are
// lifted, because their equations are not quadratic.
const CLASSICAL = [
  { name: 'Helmholtz’ oscillator, a spring softer on one side', seen: 'A spring that is softer on one side. Kahan’s map stays on closed curves, Euler’s method spirals out.', source: 'H. von Helmholtz, Die Lehre von den Tonempfindungen, 1863', field: 'xdot = v;\nvdot = -x - x^2;', eps: '0.15', at: ['1/10,0', '1/5,0', '3/10,0', '2/5,0', '12/25,0'], picked: 2, steps: 1000 },
  { name: 'The Volterra lattice of five sites', seen: 'Five species in a ring, each of which eats the next. Orbits of the map fill a torus, as those of the flow do.', source: 'M. Kac and P. van Moerbeke, Adv. Math. 16 (1975) 160', field: 'x1dot = x1*(x2 - x5);\nx2dot = x2*(x3 - x1);\nx3dot = x3*(x4 - x2);\nx4dot = x4*(x5 - x3);\nx5dot = x5*(x1 - x4);', eps: '0.05', at: ['1,2/3,1/2,1,3/4'], steps: 10000, axes: ['x1', 'x3'] },
  { name: 'Toda’s lattice of three sites', seen: 'Three particles on a ring with exponential springs, in Flaschka’s variables. The flow is integrable; look what the map keeps of that.', source: 'M. Toda, J. Phys. Soc. Japan 22 (1967) 431; H. Flaschka, Phys. Rev. B 9 (1974) 1924', field: 'a1dot = a1*(b2 - b1);\na2dot = a2*(b3 - b2);\na3dot = a3*(b1 - b3);\nb1dot = 2*(a1^2 - a3^2);\nb2dot = 2*(a2^2 - a1^2);\nb3dot = 2*(a3^2 - a2^2);', eps: '0.02', at: ['1/2,2/3,1/3,1/5,0,-1/5'], steps: 10000, axes: ['a1', 'b1'] },
  { name: 'Suslov’s problem', seen: 'A rigid body that must not turn about one of its axes. Orbits go from one steady rotation to the opposite one.', source: 'G. K. Suslov, Theoretical Mechanics, Kiev, 1902', field: 'xdot = y*(a*x + b*y);\nydot = -x*(a*x + b*y);', params: { a: '1', b: '1/2' }, eps: '0.05', at: ['1,-1', '1/2,-1/2', '-1,1/5'], steps: 1000 },
  { name: 'Darboux’ and Halphen’s system', seen: 'Three curvatures that drive each other; solutions are modular functions. Orbits come to rest slowly.', source: 'G. Halphen, C. R. Acad. Sci. 92 (1881) 1101', field: 'xdot = y*z - x*(y + z);\nydot = z*x - y*(z + x);\nzdot = x*y - z*(x + y);', eps: '0.005', at: ['1,2,-1/2', '1,2,-1/4', '1,2,-1/8'], steps: 1000 },
  { name: 'Kermack and McKendrick’s epidemic', seen: 'Healthy and infected people. Each curve is an epidemic, which ends before all have been infected.', source: 'W. O. Kermack and A. G. McKendrick, Proc. R. Soc. A 115 (1927) 700', field: 'sdot = -b*s*i;\nidot = b*s*i - g*i;', params: { b: '1/2', g: '1/5' }, eps: '0.05', at: ['99/100,1/100', '4/5,1/100', '3/5,1/100'], steps: 2000 },
  { name: 'Nosé and Hoover’s oscillator', seen: 'An oscillator with a thermostat. Some orbits lie on tori, and others wander between them.', source: 'W. G. Hoover, Phys. Rev. A 31 (1985) 1695', field: 'xdot = y;\nydot = -x - y*z;\nzdot = y^2 - 1;', eps: '0.02', at: ['0,5,0', '0,1,0', '0,3/2,0'], steps: 20000, axes: ['x', 'z'] },
  { name: 'May and Leonard’s competition', seen: 'Three competitors, of which each beats the next. Orbits go from one to the other, and stay longer each time.', source: 'R. M. May and W. J. Leonard, SIAM J. Appl. Math. 29 (1975) 243', field: 'xdot = x*(1 - x - a*y - b*z);\nydot = y*(1 - b*x - y - a*z);\nzdot = z*(1 - a*x - b*y - z);', params: { a: '4/5', b: '6/5' }, eps: '0.05', at: ['1/2,1/5,1/10', '1/4,1/4,1/3'], steps: 10000 },
  { name: 'Rössler’s band', seen: 'A band that is stretched and folded. The orbit never closes.', source: 'O. E. Rössler, Phys. Lett. A 57 (1976) 397', field: 'xdot = -y - z;\nydot = x + a*y;\nzdot = b + z*(x - c);', params: { a: '1/5', b: '1/5', c: '57/10' }, eps: '0.01', at: ['1,1,0'], steps: 20000 },
  { name: 'Rikitake’s dynamo', seen: 'Two coupled discs in their own magnetic field. The field changes its sign at times that look random.', source: 'T. Rikitake, Proc. Camb. Phil. Soc. 54 (1958) 89', field: 'xdot = -m*x + z*y;\nydot = -m*y + (z - a)*x;\nzdot = 1 - x*y;', params: { m: '1', a: '15/4' }, eps: '0.01', at: ['1,1,2'], steps: 20000, axes: ['x', 'z'] },
  { name: 'The pendulum, lifted', seen: 'It swings or turns over. Its sine and its cosine become variables, so that the field is quadratic.', source: 'C. Huygens, Horologium oscillatorium, 1673', field: 'xdot = v;\nvdot = -sin(x);', lift: 'automatic', eps: '0.1', at: ['1/2,0', '3/2,0', '5/2,0', '-4,2'], steps: 1000 },
  { name: 'Kepler’s problem, lifted', seen: 'A planet about the sun. The inverse distance becomes a variable, so that the field is quadratic.', source: 'J. Kepler, Astronomia nova, 1609', field: 'xdot = u;\nydot = v;\nudot = -x/(x^2 + y^2)^(3/2);\nvdot = -y/(x^2 + y^2)^(3/2);', lift: 'automatic', eps: '0.02', at: ['1,0,0,11/10'], steps: 2000 },
  { name: 'FitzHugh and Nagumo’s neuron, lifted', seen: 'A nerve cell that fires again and again. The cube becomes a product of variables.', source: 'R. FitzHugh, Biophys. J. 1 (1961) 445; J. Nagumo et al., Proc. IRE 50 (1962) 2061', field: 'vdot = v - v^3/3 - w + i;\nwdot = (v + 7/10 - 4/5*w)*2/25;', lift: 'automatic', params: { i: '1/2' }, eps: '0.02', at: ['1,0', '-1,1'], steps: 5000 },
]

// The number of steps of each orbit in a small picture, which is drawn when it scrolls into sight.
const THUMBNAIL_STEPS = 1000
const inSight = new IntersectionObserver(seen => {
  for (const { target, isIntersecting } of seen) {
    if (!isIntersecting) continue
    inSight.unobserve(target)
    thumbnails = thumbnails.then(() => thumbnail(target)).catch(() => {})
  }
})
let thumbnails = Promise.resolve()
let painter = null

async function thumbnail(canvas) {
  painter ||= new Asker()
  const { system, field, lift, params, eps, at, axes } = { params: {}, ...canvas.entry }
  const asked = { ...(system ? { name: system } : { field, ...(lift ? { lift } : {}) }), params }
  let scene = { eps, at, axes }
  if (!at) scene = (await painter.ask(asked, { ask: 'scene' })).answer
  if (!scene) return
  const sets = []
  let places = [2, 3]
  for (const start of scene.at) {
    const { answer, columns } = await painter.ask(asked, { ask: 'orbit', eps: scene.eps, at: start.split(','), steps: THUMBNAIL_STEPS, method: 'kahan' })
    if (!answer) return
    const { head, rows } = answer
    if (scene.axes?.length) places = scene.axes.map(name => 2 + head.variables.indexOf(name))
    if (head.variables.length < 2) places = [1, 2]
    const [xs, ys] = places.map(k => columns.subarray(k * rows, (k + 1) * rows))
    sets.push({ xs, ys, paint: '--c1', wider: -3 })
  }
  const window = ['xs', 'ys'].map(axis => span(sets.map(set => set[axis]), [-1e3, 1e3], 0.005)).map(([low, high]) => [low - 0.05 * (high - low || 1), high + 0.05 * (high - low || 1)])
  const drawn = sheet(canvas, window, NO_MARGIN)
  points(drawn, sets)
}

function card({ name, text, source, act, entry }) {
  const [item, button, canvas, title, said] = ['li', 'button', 'canvas', 'strong', 'span'].map(tag => document.createElement(tag))
  canvas.entry = entry
  canvas.setAttribute('aria-hidden', 'true')
  button.className = 'card'
  title.textContent = name
  said.textContent = text
  button.append(canvas, title)
  button.onclick = act
  item.append(button, said)
  if (source) item.append(Object.assign(document.createElement('small'), { textContent: source }))
  inSight.observe(canvas)
  return item
}

const upToTop = () => scrollTo({ top: 0 })
const group = (label, options) => {
  const made = Object.assign(document.createElement('optgroup'), { label })
  made.append(...options)
  return made
}

function gallery() {
  $('classical').replaceChildren(...CLASSICAL.map(entry => card({ name: entry.name, text: entry.seen, source: entry.source, entry, act: () => { choose(entry); upToTop() } })))
  $('gallery').replaceChildren(
    new Option('a field of your own', ''),
    group('Classical systems', CLASSICAL.map(({ name }, k) => new Option(name, `#${k}`))),
  )
  $('gallery').onchange = ({ target: { value } }) => choose(value.startsWith('#') ? CLASSICAL[value.slice(1)] : value ? { system: value } : { field: state.field, lift: state.lift })
}

// The usual values of parameters, which replace those of the catalog.
const USUAL = { lorenz: { b: '8/3' } }

// Adds the systems of the catalog to the gallery and to the menu, beside the existing entries.
async function list() {
  catalog = (await new Asker().ask(undefined, { ask: 'list' })).answer.map(one => ({ ...one, params: { ...one.params, ...USUAL[one.name] } }))
  $('catalog').replaceChildren(...catalog.map(({ name, called, title, params }) => card({ name: called, text: title, entry: { system: name, params }, act: () => { choose({ system: name }); upToTop() } })))
  $('gallery').append(group('The catalog', catalog.map(({ name, called, title }) => new Option(`${called}: ${title}`, name))))
}
