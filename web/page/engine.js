// Questions to workers. Each worker answers one question at a time; a question that is overtaken
// ends with its worker, and a fresh one starts from the module that is compiled already.
const compiled = (async () => {
  // Browsers before 2025 decode letter by letter.
  const bytes = Uint8Array.fromBase64?.(WASM) ?? Uint8Array.from(atob(WASM), letter => letter.charCodeAt(0))
  const packed = new ReadableStream({ start(stream) { stream.enqueue(bytes); stream.close() } })
  const headers = { 'content-type': 'application/wasm' }
  return WebAssembly.compileStreaming(new Response(packed.pipeThrough(new DecompressionStream('gzip')), { headers }))
})()
const workerText = URL.createObjectURL(new Blob([`(${inWorker})()`], { type: 'text/javascript' }))

class Asker {
  #worker = null
  #waiting = null

  // Starts the worker before it is asked, so that the first reply does not wait for it.
  start() {
    if (this.#worker) return
    const worker = this.#worker = new Worker(workerText)
    compiled.then(module => worker.postMessage({ module }), () => {})
    worker.onmessage = ({ data }) => this.#waiting?.hears(data)
    worker.onerror = event => {
      event.preventDefault()
      this.#end({ mistake: `This question failed, as it is beyond what a tab can compute, or by a fault of this page (${event.message}). The page goes on.` })
    }
  }

  #end(reply) {
    this.#worker?.terminate()
    this.#worker = null
    this.#waiting?.ends(reply)
    this.#waiting = null
  }

  // Ends what is asked now; its reply is null.
  stop() { if (this.#waiting) this.#end(null) }

  // The reply to a question about a subject: {answer, html, columns} or {mistake}, or null where
  // another question has overtaken it. A question that is asked twice is answered once.
  async ask(subject, question, hears = () => {}) {
    const text = JSON.stringify({ subject, question })
    if (this.#waiting?.text === text) return this.#waiting.reply
    this.stop()
    this.start()
    const worker = this.#worker
    const reply = new Promise(ends => {
      this.#waiting = {
        text,
        ends,
        hears: data => {
          if (!data.reply) return hears(data)
          this.#waiting = null
          ends(data.reply)
        },
      }
      compiled.then(
        () => worker.postMessage({ question: text }),
        error => this.#end({ mistake: `This browser cannot run the page: ${error.message}` }),
      )
    })
    this.#waiting.reply = reply
    return reply
  }
}
