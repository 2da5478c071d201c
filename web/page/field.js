// The field that is typed or chosen, its parameters, its formulas, its lift.
let chosen = { eps: false, at: false } // whether the reader or the address gave ε and the first points
let catalog = []
let sheetOf = null // the answer to `show` for the field as it is, or null where it has a mistake
let lifted = null // what `show` says of the lift, where there is one
let values = {} // of the parameters that have some
let lastTyped = -Infinity

const entry = () => catalog.find(({ name }) => name === state.system)
const named = (text, given = state.params) => Object.fromEntries(Object.entries(given).filter(([name, value]) => NUMBER.test(value) && new RegExp(`\\b${name}\\b`).test(text)))
const subject = () => ({ ...(entry() ? { name: state.system } : { field: state.field, ...lifting() }), params: named(state.field) })
let isQuadratic = false // whether the text needs no lift
const lifting = () => (state.lift && !isQuadratic ? { lift: state.lift } : {})
// A subject with values for the picture where parameters have none.
const pictured = asked => {
  const missing = Object.entries(state.shows).filter(([name]) => sheetOf?.parameters.includes(name) && !(name in values) && !(name in asked.params))
  return { ...asked, params: { ...Object.fromEntries(missing), ...asked.params } }
}
// The variables of first points and pictures.
const pointVariables = () => lifted?.coordinates || sheetOf.variables

// Another field with what belongs to it, as an act of the reader.
function choose(change) {
  state = { ...START, ...change }
  save('choose')
  open()
}

// The state is another one, by the history or the address; what was found stays where the field
// does.
function reopen(next) {
  const key = () => JSON.stringify([state.system, state.field, state.lift, named(state.field)])
  const before = key()
  state = next
  if (!sheetOf || key() !== before) return open()
  chosen = { eps: Boolean(state.eps), at: Boolean(state.at.length) }
  $('steps').value = state.steps
  fitted = null
  parameters(sheetOf.parameters)
  return orbitsAnew()
}

function open() {
  const known = entry()
  if (known) state = { ...state, field: known.text, params: { ...known.params, ...state.params } }
  chosen = { eps: Boolean(state.eps), at: Boolean(state.at.length) }
  $('field').value = state.field
  $('steps').value = state.steps
  $('gallery').value = state.system || `#${CLASSICAL.findIndex(({ field }) => field === state.field)}`
  if ($('gallery').selectedIndex < 0) $('gallery').value = ''
  fitted = null
  forget()
  foresee()
  return refresh()
}

// The first orbit is computed while the field is read, where ε and a first point are known.
function foresee() {
  if (state.field && state.eps && state.at.length) mover.ask(subject(), orbitFrom(state.at[0], 'kahan', state.eps))
}

// The field is another one, and so are ε, the first points and the axes.
function typed() {
  chosen = { eps: false, at: false }
  state = { ...state, system: '', field: $('field').value, eps: '', at: [], picked: 0, steps: START.steps, axes: [], section: [], view: null }
  $('steps').value = state.steps
  fitted = null
  $('gallery').value = ''
  lastTyped = performance.now()
  save('type')
  forget()
  later(refresh)
}

// Milliseconds without a key before a mistake is shown.
const PAUSE = 600

async function refresh() {
  // A lift applies to texts that are not quadratic as they are written.
  isQuadratic = true
  const plain = state.lift && await lead.ask(subject(), { ask: 'show' })
  if (plain === null) return
  isQuadratic = !plain.mistake
  const reply = await lead.ask(subject(), { ask: 'show', as: 'latex' })
  if (!reply) return
  ;[sheetOf, relationErrors] = [null, []]
  if (reply.mistake) {
    const since = lastTyped
    const left = PAUSE - (performance.now() - lastTyped)
    if (left > 0) await new Promise(ends => setTimeout(ends, left))
    if (since !== lastTyped || sheetOf) return
  }
  $('mistake').hidden = $('first').hidden = !reply.mistake
  $('read').hidden = Boolean(reply.mistake)
  $('offer').hidden = !reply.lifts
  $('lifting').hidden = !state.lift || !(reply.mistake || reply.lifted)
  $('which-lift').value = state.lift
  $('first').textContent = `${reply.lifts ? 'Lift or correct the field first.' : 'Correct the field first.'} The picture is of the field before.`
  $('mistake').textContent = `${reply.mistake || ''}${reply.lifts ? `help: press “${$('lift').textContent}”` : ''}`
  $('field').setAttribute('aria-invalid', String(Boolean(reply.mistake)))
  for (const id of ['rest', 'picture']) $(id).disabled = Boolean(reply.mistake)
  if (reply.mistake) return
  lastDrawn = []
  sheetOf = { ...reply.answer, parameters: reply.parameters }
  lifted = reply.lifted
  showLift()
  set('formulas', reply.html)
  values = reply.values
  state.shows = Object.fromEntries(Object.entries(state.shows).filter(([name]) => reply.parameters.includes(name)))
  say('read', reading())
  parameters(reply.parameters)
  mover.start()
  if (isWanted) search()
  if ($('jacobian').open) await jacobian()
  await orbitsAnew()
}

// How the text was read, with what may have been meant otherwise.
function reading() {
  const variables = pointVariables()
  const list = names => names.map(name => `\`${name}\``).join(', ')
  const parts = [`Variables: ${list(variables)}.`]
  if (sheetOf.parameters.length) parts.push(`Parameters: ${list(sheetOf.parameters)}.`)
  for (const name of sheetOf.parameters) {
    const product = [...name].join('*')
    if (name.length > 1 && [...name].every(letter => variables.includes(letter))) parts.push(`\`${name}\` is one name; is \`${product}\` meant?`)
  }
  for (const name of variables) if (/^.d$/.test(name) && !variables.includes(name[0])) parts.push(`\`${name}dot\` is read as the derivative of \`${name}\`; write \`${name[0]}'' = …\` for a second derivative.`)
  return parts.join(' ')
}

function showLift() {
  // A tangent vector of a lifted field is in more variables than its orbit.
  $('exponents').hidden = Boolean(lifted)
  $('lifted').hidden = !lifted
  if (!lifted) return
  set('lift-shown', lifted.html)
  $('growing').hidden = !lifted.warning
  $('growing').textContent = lifted.warning ? `Note: ${lifted.warning}.` : ''
  // The heading says where the answer stands, as the button is gone.
  if (isLifting) $('h-lift').focus()
  isLifting = false
}

let isLifting = false // whether a lift was asked for by the button

// Another lift of the same text, or none.
function lift(which) {
  state = { ...state, lift: which, system: '' }
  save('lift')
  forget()
  return refresh()
}

// The slider of a parameter goes from minus to plus twice its size, of a parameter without size
// from −2 to 2.
function rangeOf(value) {
  const size = Math.abs(value) || 1
  return { min: -2 * size, max: 2 * size, step: decimal(size / 50, 1) }
}

function parameters(names) {
  const box = $('parameters')
  const shown = name => state.params[name] || values[name] || state.shows[name] || '1'
  if (names.join() === [...box.querySelectorAll('input[type=text]')].map(input => input.name).join()) {
    for (const input of box.querySelectorAll('input')) {
      if (input === document.activeElement) continue
      if (input.type === 'text') {
        input.value = state.params[input.name] || ''
        input.placeholder = values[input.name] || `any (${shown(input.name)})`
      } else setSlider(input, valueOf(shown(input.name)))
    }
    return
  }
  box.replaceChildren(...names.map(name => {
    const [row, label] = [document.createElement('div'), document.createElement('label')]
    row.className = 'row parameter'
    const input = Object.assign(document.createElement('input'), { type: 'text', name, value: state.params[name] || '', size: 8, placeholder: values[name] || `any (${shown(name)})` })
    input.oninput = () => {
      const value = input.value.trim()
      state.params = { ...state.params, [name]: value }
      if (!checked(input, !value || NUMBER.test(value), `${name} = ${value}`)) return
      save(`parameter ${name}`)
      forget(name)
      later(refresh)
    }
    const slider = Object.assign(document.createElement('input'), { type: 'range', name, ariaLabel: `${name} in the picture` })
    setSlider(slider, valueOf(shown(name)), true)
    slider.oninput = () => {
      // A parameter that is generic in formulas has a value in the picture alone.
      if (state.params[name] || values[name] && !(name in state.shows)) {
        state.params = { ...state.params, [name]: slider.value }
        input.value = slider.value
        save(`parameter ${name}`)
        forget(name)
        later(refresh)
      } else {
        state.shows = { ...state.shows, [name]: slider.value }
        input.placeholder = `any (${slider.value})`
        save(`parameter ${name}`)
        move()
      }
    }
    label.append(`${name} = `, input)
    row.append(label, slider)
    return row
  }))
}

function setSlider(slider, value, isNew = false) {
  if (isNew || value < Number(slider.min) || value > Number(slider.max)) Object.assign(slider, rangeOf(value))
  slider.value = value
}

// Says what is wrong with what stands in an input, or that nothing is.
function checked(input, isRight, what) {
  input.setAttribute('aria-invalid', String(!isRight))
  const comma = /^[-−]?\d+,\d+$/.test(input.value.trim()) ? ` Write ${input.value.trim().replace(',', '.')}.` : ' Write a decimal, such as 0.15, or a fraction, such as 3/20.'
  $('refused').textContent = isRight ? '' : `${what} is no number.${comma}`
  return isRight
}

async function jacobian() {
  const reply = await lead.ask(subject(), { ask: 'show', as: 'latex', jacobian: true })
  if (reply && !reply.mistake) set('jacobian-shown', reply.html)
}

let timer = 0
const later = work => { clearTimeout(timer); timer = setTimeout(work, 120) }

async function copy(kind, button) {
  const withJacobian = $('jacobian').open && kind !== 'kahan'
  const reply = await lead.ask(subject(), { ask: 'show', as: kind, jacobian: withJacobian })
  if (!reply) return
  const what = kind === 'kahan' ? 'the field' : `the map, A, b${withJacobian ? ' and the Jacobian' : ''}`
  copied('copied', `${what} as ${button.textContent}`, reply.mistake || written(reply.answer, kind))
}

async function copied(id, what, text) {
  try {
    await navigator.clipboard.writeText(text)
    $(id).textContent = `Copied ${what}.`
  } catch {
    prompt(`To be copied, ${what}:`, text)
  }
}

// The formulas of a sheet, a line each.
function written(answer, kind) {
  if (kind === 'kahan') return answer.macro
  if (kind === 'sympy') return answer.script
  const [name, row, open, close] = kind === 'latex'
    ? [v => `\\widetilde{${v}}`, rows => rows.map(row => row.join(' & ')).join(' \\\\ '), '\\begin{pmatrix} ', ' \\end{pmatrix}']
    : [v => `${v}~`, rows => rows.map(row => `[${row.join(', ')}]`).join(', '), '[', ']']
  const matrix = (called, rows) => (rows ? [`${called} = ${open}${row(rows)}${close}`] : [])
  const map = answer.map || answer.variables.map(() => '(beyond the budget of terms)')
  return [
    ...answer.variables.map((v, k) => `${name(v)} = ${map[k]}`),
    ...matrix('A', answer.A), ...matrix('b', answer.b.map(value => [value])), ...matrix('J', answer.jacobian),
  ].join('\n')
}
