// Reads the field that the user types or chooses, and shows its parameters, formulas and lift.
let chosen = { eps: false, at: false } // whether ε and the first points are known
let catalog = []
let sheetOf = null // the answer to `show` for the current field, or null if the field has a mistake
let lifted = null // the lift in the answer to `show`, if the field has a lift
let values = {} // the values of parameters in the answer to `show`, by name
let lastTyped = -Infinity

const entry = () => catalog.find(({ name }) => name === state.system)
const named = (text, given = state.params) => Object.fromEntries(Object.entries(given).filter(([name, value]) => NUMBER.test(value) && new RegExp(`\\b${name}\\b`).test(text)))
const subject = () => ({ ...(entry() ? { name: state.system } : { field: state.field, ...lifting() }), params: named(state.field) })
let isQuadratic = false // whether the field is quadratic as it is written
const lifting = () => (state.lift && !isQuadratic ? { lift: state.lift } : {})
// Returns the subject `asked`, with the picture's values for parameters that have no value.
const pictured = asked => {
  const missing = Object.entries(state.shows).filter(([name]) => sheetOf?.parameters.includes(name) && !(name in values) && !(name in asked.params))
  return { ...asked, params: { ...Object.fromEntries(missing), ...asked.params } }
}
// Returns the variables of first points and axes: for a lifted field, the original variables.
const pointVariables = () => lifted?.coordinates || sheetOf.variables

// Replaces the field and everything that belongs to it, and adds an entry to the history.
function choose(change) {
  state = { ...START, ...change }
  save('choose')
  open()
}

// Shows the state `next`, which comes from the browser's history or the address. Keeps the results
// of the search if the field stays the same.
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

// Starts to compute the first orbit while the field is read, if ε and a first point are known.
function foresee() {
  if (state.field && state.eps && state.at.length) mover.ask(subject(), orbitFrom(state.at[0], 'kahan', state.eps))
}

// Takes the field from the text area, and clears ε, the first points, the axes and the view.
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

// The time without a key press before the page shows a mistake, in milliseconds.
const PAUSE = 600

async function refresh() {
  // Tries the text without the lift first; the lift applies only if this attempt fails.
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

// Returns sentences which name the variables and parameters, and point out likely misreadings.
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
  // Hides the exponent of a lifted field, whose tangent vectors have more variables than its orbit.
  $('exponents').hidden = Boolean(lifted)
  $('lifted').hidden = !lifted
  if (!lifted) return
  set('lift-shown', lifted.html)
  $('growing').hidden = !lifted.warning
  $('growing').textContent = lifted.warning ? `Note: ${lifted.warning}.` : ''
  // Moves the focus to the heading of the lift, because the pressed button is now hidden.
  if (isLifting) $('h-lift').focus()
  isLifting = false
}

let isLifting = false // whether the user has just pressed the button for a lift

// Lifts the same text by the method `which`, or removes the lift if `which` is empty.
function lift(which) {
  state = { ...state, lift: which, system: '' }
  save('lift')
  forget()
  return refresh()
}

// Returns the range and step of a parameter's slider. The range is from −2|value| to 2|value|, or
// from −2 to 2 if the value is 0.
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
      // Changes only the picture if the parameter has no value in the formulas.
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

// Shows a message if `isRight` is false, or clears the message; returns `isRight`.
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

// Returns the formulas for the clipboard: as text or LaTeX line by line, or for `kahan!` or SymPy.
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
