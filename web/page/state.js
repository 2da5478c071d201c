// The state of the page, which its address holds: field or system, which lift, params, eps, at, steps,
// axes, beside.
const START = { system: '', field: '', lift: '', params: {}, eps: '', at: [], steps: 4000, axes: [], beside: [] }

// The lifts that can be asked for, by their names in questions.
const LIFTS = {
  automatic: 'the usual one',
  energy: 'one that keeps an energy',
  relations: 'one that keeps relations',
  stable: 'one whose errors do not grow',
  smallest: 'one with the fewest variables',
}

function readAddress() {
  const given = new URLSearchParams(location.hash.slice(1))
  if (!given.has('field') && !given.has('system')) return { ...START, ...CLASSICAL[0] }
  const list = (name, between) => (given.get(name) || '').split(between).filter(Boolean)
  return {
    system: given.get('system') || '',
    field: given.get('field') || '',
    lift: given.get('lift') in LIFTS ? given.get('lift') : '',
    params: Object.fromEntries(given.getAll('param').map(text => text.split('='))),
    eps: given.get('eps') || '',
    at: list('at', ';'),
    steps: Math.min(1e6, Number(given.get('steps')) || START.steps),
    axes: list('axes', ','),
    beside: list('beside', ',').filter(name => name in METHODS),
  }
}

function address(state) {
  const given = new URLSearchParams(state.system ? { system: state.system } : { field: state.field })
  if (state.lift) given.set('lift', state.lift)
  for (const [name, value] of Object.entries(state.params)) if (value) given.append('param', `${name}=${value}`)
  given.set('eps', state.eps)
  given.set('at', state.at.join(';'))
  given.set('steps', state.steps)
  given.set('axes', state.axes.join(','))
  if (state.beside.length) given.set('beside', state.beside.join(','))
  return `#${given}`
}

// A number as questions have it, exactly: a fraction or a decimal.
const NUMBER = /^[-−]?\d+(\.\d+)?(e-?\d+)?(\/\d+)?$/i
const valueOf = text => {
  const [above, below = '1'] = text.replace('−', '-').split('/')
  return Number(above) / Number(below)
}
