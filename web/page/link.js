// Keeps the state of the page in its address and in the tab's history. Each action of the user is
// an entry of the history, so the browser's Back and the page's Undo do the same.
const START = { system: '', field: '', lift: '', params: {}, shows: {}, eps: '', at: [], picked: 0, steps: 4000, axes: [], beside: ['euler', 'rk4'], over: [], section: [], view: null, turn: [-0.9, 0.3] }
const MOST_STEPS = 1e6
const MOST_ORBITS = 12

// The kinds of lift: the name in questions to a worker, and the description in the menu.
const LIFTS = {
  automatic: 'the usual one',
  energy: 'one that keeps an energy',
  relations: 'one that keeps relations',
  stable: 'one whose errors do not grow',
  smallest: 'one with the fewest variables',
}

const isEmbedded = new URLSearchParams(location.hash.slice(1)).has('embed')
// The claims in the link, in the syntax of the macro `kahan!`, until the page proves these again.
let brought = new URLSearchParams(location.hash.slice(1)).get('found')?.split('\n')
// The largest number of characters of the claims in an address.
const MOST_FOUND = 8192

// Returns the current address, with the results of the search if these are short enough.
function linkWithFindings() {
  const found = searched?.lines?.length ? `&${new URLSearchParams({ found: searched.lines.join('\n') })}` : ''
  return location.href + (found.length <= MOST_FOUND ? found : '')
}

function readAddress() {
  const given = new URLSearchParams(location.hash.slice(1))
  if (!given.has('field') && !given.has('system')) return { ...START, ...CLASSICAL[0] }
  const list = (name, between) => (given.get(name) || '').split(between).filter(Boolean)
  const pairs = name => Object.fromEntries(given.getAll(name).map(text => text.split('=')))
  const [ends, angles, crossed] = [list('view', ',').map(Number), list('turn', ',').map(Number), list('section', '=')]
  return {
    system: given.get('system') || '',
    field: given.get('field') || '',
    lift: given.get('lift') in LIFTS ? given.get('lift') : '',
    params: pairs('param'),
    shows: pairs('show'),
    eps: NUMBER.test(given.get('eps')) ? given.get('eps') : '',
    at: list('at', ';').slice(0, MOST_ORBITS),
    picked: Math.max(0, Math.round(given.get('pick')) || 0),
    steps: Math.min(MOST_STEPS, Math.max(1, Math.round(given.get('steps')) || START.steps)),
    axes: list('axes', ','),
    beside: given.has('beside') ? list('beside', ',').filter(name => name in METHODS) : START.beside,
    over: list('over', ',').filter(name => name in OVERLAYS),
    section: crossed.length === 2 && NUMBER.test(crossed[1]) ? crossed : [],
    view: ends.length === 4 && ends.every(Number.isFinite) && ends[0] < ends[1] && ends[2] < ends[3] ? [ends.slice(0, 2), ends.slice(2)] : null,
    turn: angles.length === 2 && angles.every(Number.isFinite) ? angles : START.turn,
  }
}

function address(state) {
  const given = new URLSearchParams(state.system ? { system: state.system } : { field: state.field })
  if (state.lift) given.set('lift', state.lift)
  for (const [kind, values] of [['param', state.params], ['show', state.shows]]) {
    for (const [name, value] of Object.entries(values)) if (value) given.append(kind, `${name}=${value}`)
  }
  given.set('eps', state.eps)
  given.set('at', state.at.join(';'))
  if (state.picked) given.set('pick', state.picked)
  given.set('steps', state.steps)
  given.set('axes', state.axes.join(','))
  given.set('beside', state.beside.join(','))
  if (state.over.length) given.set('over', state.over.join(','))
  if (state.section.length) given.set('section', state.section.join('='))
  if (state.view) given.set('view', state.view.flat().map(end => decimal(end, 5)).join(','))
  if (isSpace()) given.set('turn', state.turn.map(angle => decimal(angle, 4)).join(','))
  if (isEmbedded) given.set('embed', '1')
  return `#${given}`
}

// The syntax of a number in questions to a worker: a decimal or a fraction.
const NUMBER = /^[-−]?\d+(\.\d+)?(e-?\d+)?(\/\d+)?$/i
const valueOf = text => {
  const [above, below = '1'] = text.replace('−', '-').split('/')
  return Number(above) / Number(below)
}
const decimal = (number, digits = 3) => String(Number(number.toPrecision(digits)))

// Writes the state into the address. A new action adds an entry to the history. If the same action
// goes on within a second, such as a drag, its entry is replaced.
const visited = { place: history.state?.place ?? 0, last: history.state?.place ?? 0, act: '', at: 0 }
function save(act = '') {
  const goesOn = act === visited.act && performance.now() - visited.at < 1000
  const to = address({ ...state, params: named(state.field), shows: named(state.field, state.shows) })
  if (act) [visited.act, visited.at] = [act, performance.now()]
  if (act && !goesOn && to !== location.hash) {
    visited.last = ++visited.place
    history.pushState({ place: visited.place }, '', to)
  } else history.replaceState({ place: visited.place }, '', to)
  undoable()
}

function undoable() {
  $('undo').disabled = visited.place === 0
  $('redo').disabled = visited.place >= visited.last
}

addEventListener('popstate', ({ state: entry }) => {
  visited.place = entry?.place ?? 0
  visited.act = ''
  undoable()
  reopen(readAddress())
})
