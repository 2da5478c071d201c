// Sends questions to web workers; each worker answers one question at a time. A new question
// terminates the busy worker, and starts another worker with the module that is already compiled.
const compiled = (async () => {
  // Decodes letter by letter in older browsers, which lack `Uint8Array.fromBase64`.
  const bytes = Uint8Array.fromBase64?.(WASM) ?? Uint8Array.from(atob(WASM), letter => letter.charCodeAt(0))
  const packed = new ReadableStream({ start(stream) { stream.enqueue(bytes); stream.close() } })
  const headers = { 'content-type': 'application/wasm' }
  return WebAssembly.compileStreaming(new Response(packed.pipeThrough(new DecompressionStream('gzip')), { headers }))
})()
const workerText = URL.createObjectURL(new Blob([`(${inWorker})()`], { type: 'text/javascript' }))

class Asker {
  #worker = null
  #waiting = null

  // Starts the worker ahead of its first question, unless the worker already runs.
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

  // Ends the current question with the reply null, and terminates the worker.
  stop() { if (this.#waiting) this.#end(null) }

  // Returns a promise of the reply: {answer, html, columns} or {mistake}, or null after a newer
  // question. Returns the pending promise if the worker is busy with the same question.
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
