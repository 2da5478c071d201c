// The worker's side: opens the module once, then answers one question after the other.
// It is written as a function, because a page from file:// makes its workers of a text.
function inWorker() {
  let module
  const text = (at, length) => new TextDecoder().decode(new Uint8Array(module.memory.buffer, at, length))
  const page = {
    now: () => performance.now(),
    look: (at, length) => {
      const look = JSON.parse(text(at, length))
      if ('failed' in look) throw new Error(look.failed)
      postMessage({ look })
    },
    found: (at, length) => postMessage({ found: JSON.parse(text(at, length)) }),
  }
  const answer = question => {
    const bytes = new TextEncoder().encode(question)
    const room = module.room(bytes.length)
    new Uint8Array(module.memory.buffer, room, bytes.length).set(bytes)
    const length = module.ask()
    const reply = JSON.parse(text(module.answer(), length))
    reply.columns = new Float64Array(module.memory.buffer, module.columns(), module.floats()).slice()
    return reply
  }
  // What is thrown here, by the module too, is an `error` that the page hears of.
  self.onmessage = ({ data }) => {
    if (data.module) module = new WebAssembly.Instance(data.module, { page }).exports
    else {
      const reply = answer(data.question)
      postMessage({ reply }, [reply.columns.buffer])
    }
  }
}
