// Starts the page: connects its parts, and shows the field of the address or the first example.
const [lead, mover, follower, firstly, planner] = Array.from({ length: 5 }, () => new Asker())
const workers = { search: new Asker(), exponent: new Asker(), heights: new Asker(), poles: new Asker() }
const $ = id => document.getElementById(id)
let state = readAddress()

// Writes a text into an element, and marks the parts between backticks as code.
const say = (id, text) => $(id).replaceChildren(...text.split('`').map((part, k) => (k % 2 ? Object.assign(document.createElement('code'), { textContent: part }) : part)))

// Lets the Tab key reach each box that scrolls, and gives the box a name.
const stops = new ResizeObserver(seen => {
  for (const { target: box } of seen) {
    const label = box.closest('.preserved')?.querySelector('.source')?.textContent || 'A formula or a table wider than the page'
    if (box.scrollWidth > box.clientWidth) Object.assign(box, { tabIndex: 0, role: 'group', ariaLabel: label })
    else for (const name of ['tabindex', 'role', 'aria-label']) box.removeAttribute(name)
  }
})

// Fills an element with HTML from a worker, and changes h4 to h3, the level below a section's h2.
function set(id, html) {
  $(id).innerHTML = html.replace(/`([^`<>]*)`/g, '<code>$1</code>').replace(/<(\/?)h4/g, '<$1h3')
  for (const box of $(id).querySelectorAll('[tabindex]')) stops.observe(box)
}

function wire() {
  document.body.classList.toggle('embedded', isEmbedded)
  $('field').oninput = typed
  $('lift').onclick = () => {
    isLifting = true
    lift('automatic')
  }
  $('unlift').onclick = () => { lift(''); $('field').focus() }
  $('which-lift').replaceChildren(...Object.entries(LIFTS).map(([name, meaning]) => new Option(meaning, name)))
  $('which-lift').onchange = ({ target: { value } }) => lift(value)
  $('jacobian').ontoggle = () => { if ($('jacobian').open && sheetOf) jacobian() }
  for (const made of document.querySelectorAll('[data-copy]')) made.onclick = () => copy(made.dataset.copy, made)
  wirePortrait()
  wireTime()
  wirePlane()
  wireSearch()
}

async function begin() {
  lead.start()
  foresee()
  wire()
  undoable()
  const { answer, mistake } = await lead.ask(undefined, { ask: 'style' })
  $('mistake').hidden = !mistake
  $('mistake').textContent = mistake || ''
  document.head.prepend(Object.assign(document.createElement('style'), { textContent: answer || '' }))
  document.body.classList.add('ready')
  if (mistake) return
  gallery()
  // Loads the catalog after the field, because the catalog takes longer. Loads the catalog first if
  // the address names one of its systems.
  if (state.system) {
    await list()
    open()
  } else {
    await open()
    list()
  }
}
begin()
