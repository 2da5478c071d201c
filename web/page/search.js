// Runs the long computations, each in its own worker: invariants, exponents, heights and poles.
let searched = null // the subject, the equations and the results of the last search, or null
let isWanted = false // whether a search starts once the page has read the field

// The time limit of the automatic search for each new field, in seconds.
const FIRST_SEARCH = 4

// Deletes outdated results: all results after a change of the field, or those for the old value of
// the parameter `changed`. Lets a search that is under way start again.
function forget(changed) {
  // Deletes the orbits, because orbits of a new field have other columns.
  if (!changed) [sheetOf, lastDrawn] = [null, []]
  const holds = changed && !(changed in (searched?.subject.params || {}))
  isWanted ||= $('search').classList.contains('running') && !holds
  for (const name of Object.keys(workers)) {
    if (name === 'search' && holds) continue
    workers[name].stop()
    $(name).classList.remove('running')
    for (const id of [`${name}-shown`, `${name}-stage`]) $(id).replaceChildren()
  }
  for (const id of ['copied', 'copied-found', 'linked']) $(id).replaceChildren()
  $('jacobian-shown').replaceChildren()
  if (!holds) {
    searched = null
    $('arrived').hidden = $('copies-found').hidden = true
  } else if (searched?.equations) $('search-stage').textContent = `This was found for generic ${changed}, and so holds at its value, too.`
}

// Asks a question; a second press of the button stops the question. A double click is one press.
async function long(id, question, shows, hears = () => {}, about = subject()) {
  const [button, begun] = [$(id), performance.now()]
  if (button.classList.contains('running')) {
    if (begun - Number(button.dataset.begun) > 500) workers[id].stop()
    return
  }
  const stage = $(`${id}-stage`)
  stage.replaceChildren()
  button.dataset.begun = begun
  button.classList.add('running')
  let look = null
  const clock = () => {
    const { what, done, of } = look || {}
    const seconds = `${Math.round((performance.now() - begun) / 1000)} s${question.seconds ? ` of ${question.seconds}` : ''}`
    stage.textContent = what ? `${of ? `${done} of ${of} ${what}` : `${what} …`} (${seconds})` : seconds
  }
  const ticking = setInterval(clock, 1000)
  const reply = await workers[id].ask(about, question, data => {
    if (data.look) { look = data.look; clock() }
    hears(data)
  })
  clearInterval(ticking)
  // Returns early if the field has changed, because `forget` has already reset the button.
  if (!reply && !button.classList.contains('running')) return
  button.classList.remove('running')
  say(stage.id, reply ? reply.mistake || '' : 'Stopped.')
  if (reply && !reply.mistake) shows(reply)
}

const seconds = () => {
  const given = Math.round($('seconds').value)
  $('seconds').value = given >= 1 && given <= 3600 ? given : 30
  return Number($('seconds').value)
}

function search() {
  const [list, asked] = [$('arrived'), subject()]
  isWanted = false
  endFirst()
  if (!$('search').classList.contains('running')) {
    searched = { subject: asked }
    list.textContent = ''
    $('copies-found').hidden = true
  }
  return long('search', { ask: 'discover', seconds: seconds() }, reply => foundAll(asked, reply), ({ found }) => {
    if (!found) return
    list.hidden = false
    list.textContent += `${found.text}\n`
  })
}

// Runs the short automatic search for a field, in its own worker.
let endFirst = () => {}
async function searchFirst() {
  const asked = subject()
  if (searched || $('search').classList.contains('running')) return undefined
  const kept = keptFor(asked)
  if (kept) return foundAll(asked, kept)
  if (brought && await foundInLink(asked)) return undefined
  let isOver = false
  endFirst = () => { isOver = true; firstly.stop() }
  const reply = await firstly.ask(asked, { ask: 'discover', seconds: FIRST_SEARCH })
  if (isOver || !reply || reply.mistake || searched || JSON.stringify(asked) !== JSON.stringify(subject())) return undefined
  return foundAll(asked, reply)
}

// Proves the claims in the link, and shows proved claims. Returns false if the proof fails.
async function foundInLink(asked) {
  const lines = brought
  brought = undefined
  searched = { subject: asked }
  const own = searched
  searched.equations = await equationsOf(asked)
  const reply = await firstly.ask(claimed(lines), { ask: 'show', as: 'latex' })
  if (searched !== own) return true
  searched = null
  if (!reply?.answer) return false
  const claims = new DOMParser().parseFromString(reply.html, 'text/html').querySelectorAll('.preserved')
  const of = kind => lines.filter(line => line.startsWith(`${kind} `))
  await shownAll(asked, { integrals: of('integral'), densities: of('density'), brackets: of('bracket'), drifts: of('drift') }, [...claims].map(one => one.outerHTML).join(''))
  $('search-stage').textContent = 'These came with the link, and were proved once more.'
  return true
}

async function foundAll(asked, { answer, html }) {
  keep(asked, { answer, html })
  $('search-stage').textContent = `${answer.independent_integrals} independent integrals; growth of degrees: ${answer.growth}${answer.growth_proved ? ', proved' : ''}. Found in ${answer.seconds.toFixed(1)} s.`
  await shownAll(asked, answer, html)
}

async function shownAll(asked, answer, html) {
  const list = $('arrived')
  set('search-shown', html)
  const lines = [...answer.integrals, ...answer.densities, ...answer.brackets, ...answer.drifts]
  list.textContent = lines.join('\n')
  list.hidden = $('copies-found').hidden = !lines.length
  searched = { subject: asked }
  const own = searched
  const equations = await equationsOf(asked)
  if (!equations || searched !== own) return
  searched = { ...searched, equations, lines, integrals: answer.integrals }
  move()
}

// Returns the equations with named parameters, because each claim states its values of parameters.
async function equationsOf(asked) {
  const sheet = await workers.search.ask({ ...asked, params: {} }, { ask: 'show' })
  const right = sheet?.answer && (sheet.answer.field_at_eps ?? sheet.answer.field)
  return right && sheet.answer.variables.map((name, k) => `${name}dot = ${right[k]};`)
}

// Stores the results of a search in the tab, so that a reload shows the results at once.
function keep(asked, reply) {
  try {
    sessionStorage.setItem(`found ${JSON.stringify(asked)}`, JSON.stringify(reply))
  } catch {
    // Empties the storage if the storage is full; a search can find the results again.
    sessionStorage.clear()
  }
}

function keptFor(asked) {
  try {
    return JSON.parse(sessionStorage.getItem(`found ${JSON.stringify(asked)}`))
  } catch {
    return null
  }
}

// Copies the results of the search, in the syntax of the macro `kahan!` or as LaTeX.
async function copyFound(kind) {
  if (kind === 'text') { copied('copied-found', 'what was found as text', searched.lines.join('\n')); return }
  const reply = await lead.ask(claimed(searched.lines), { ask: 'show', as: 'latex' })
  if (!reply) return
  const lines = reply.mistake || reply.answer.claims.flatMap(({ equations }) => equations.map(sides => sides.join(' = '))).join('\n')
  copied('copied-found', 'what was found as LaTeX', lines)
}

// Returns the subject of the search, with the claims `lines` after its equations.
function claimed(lines) {
  // Keeps the original equations of a lifted field, so that points stay in the original variables.
  if (lifted) return { ...searched.subject, field: [searched.subject.field, ...lines].join('\n') }
  const field = [...searched.equations, ...lines].join('\n')
  const params = named(field)
  // The values of parameters that the text itself gives.
  const own = Object.entries(values).filter(([name]) => !(name in params) && new RegExp(`\\b${name}\\b`).test(field))
  return { field: [...own.map(([name, value]) => `${name} = ${value};`), field].join('\n'), params }
}

// Returns the subject with its own integrals or those of the search, and with the picture's values.
function measured() {
  const integrals = searched?.integrals || []
  return pictured(integrals.length && !sheetOf.claims.some(({ kind }) => kind === 'integral') ? claimed(integrals) : subject())
}

function wireSearch() {
  for (const made of document.querySelectorAll('[data-found]')) made.onclick = () => copyFound(made.dataset.found)
  $('search').onclick = search
  $('exponent').onclick = () => {
    const { eps, at, picked, steps } = state
    long('exponent', { ask: 'exponent', eps, at: at[picked]?.split(',') || [], steps }, ({ answer: { value, error, steps } }) => {
      const number = value => (value === null ? 'unknown' : short(Number(value.toPrecision(3))))
      $('exponent-shown').textContent = `λ = ${number(value)}, converged to about ${number(error)}, in ${steps} steps of Δt = ${short(2 * valueOf(eps))} from ${at[picked]}.`
    }, undefined, pictured(subject()))
  }
  $('heights').onclick = () => long('heights', { ask: 'heights', eps: state.eps, at: state.at[state.picked]?.split(',') || [], steps: 60, digits: 20000, seconds: 10 }, ({ answer, html }) => {
    set('heights-shown', html)
    $('heights-stage').textContent = `Growth is ${answer.growth}, over ${answer.steps} steps.`
  })
  $('poles').onclick = () => long('poles', { ask: 'poles', seconds: 20 }, ({ html, answer }) => {
    set('poles-shown', html)
    $('poles-stage').textContent = `The degrees of the iterates are ${answer.degrees.join(', ')}: growth is ${answer.growth}.`
  })
}
