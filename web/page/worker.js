// The worker's side: opens the module once, then answers one question after the other.
// It is written as a function, because a page from file:// makes its workers of a text.
function inWorker() {
  let module
  const text = (at, length) => JSON.parse(new TextDecoder().decode(new Uint8Array(module.memory.buffer, at, length)))
  const page = {
    now: () => performance.now(),
    look: (at, length) => postMessage({ look: text(at, length) }),
    found: (at, length) => postMessage({ found: text(at, length) }),
  }
  const answer = question => {
    const bytes = new TextEncoder().encode(question)
    const room = module.room(bytes.length)
    new Uint8Array(module.memory.buffer, room, bytes.length).set(bytes)
    const length = module.ask()
    const reply = text(module.answer(), length)
    reply.columns = new Float64Array(module.memory.buffer, module.columns(), module.floats()).slice()
    return reply
  }
  self.onmessage = async ({ data }) => {
    if (data.module) module = (await WebAssembly.instantiate(data.module, { page })).exports
    else {
      const reply = answer(data.question)
      postMessage({ id: data.id, reply }, [reply.columns.buffer])
    }
  }
}
