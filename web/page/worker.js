// Runs in a web worker: opens the WebAssembly module once, then answers question after question.
// The page starts workers from this function's text, because workers cannot load from file://.
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
  // Passes exceptions on, also those of the module; the page receives each as an `error` event.
  self.onmessage = ({ data }) => {
    if (data.module) module = new WebAssembly.Instance(data.module, { page }).exports
    else {
      const reply = answer(data.question)
      postMessage({ reply }, [reply.columns.buffer])
    }
  }
}
