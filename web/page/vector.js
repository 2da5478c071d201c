// Replaces a canvas, and records the drawing as SVG; has only the methods that this page uses.
class VectorCanvas {
  #under = [] // the elements below all others, drawn in the mode `destination-over`
  #over = []
  #path = ''
  #isClipped = false
  #frame = ''
  constructor({ clientWidth, clientHeight }) {
    Object.assign(this, { clientWidth, clientHeight, width: clientWidth, height: clientHeight, globalAlpha: 1, lineWidth: 1, textAlign: 'left' })
  }

  getContext() { return this }
  setTransform() {}
  setAttribute() {}
  save() {}
  restore() { [this.#isClipped, this.globalAlpha] = [false, 1] }
  // Clips to the current path, which is always the frame of the picture.
  clip() { [this.#isClipped, this.#frame] = [true, this.#path] }
  measureText(text) { return { width: 7 * text.length } }

  beginPath() { this.#path = '' }
  moveTo(x, y) { this.#path += `M${this.#at(x, y)}` }
  lineTo(x, y) { this.#path += `${this.#path ? 'L' : 'M'}${this.#at(x, y)}` }
  rect(x, y, width, height) { this.#path += `M${this.#at(x, y)}h${width}v${height}h${-width}z` }
  arc(x, y, r) { this.#path += `M${this.#at(x - r, y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z` }
  stroke() { this.#put(`<path d="${this.#path}" fill="none" stroke="${this.strokeStyle}" stroke-width="${this.lineWidth}" opacity="${this.globalAlpha}"/>`) }
  fill() { this.#put(`<path d="${this.#path}" fill="${this.fillStyle}"/>`) }
  fillText(text, x, y) { this.#put(`<text x="${x}" y="${y}" fill="${this.fillStyle}" text-anchor="${{ left: 'start', center: 'middle', right: 'end' }[this.textAlign]}">${text}</text>`) }

  // Draws squares of one size and colour; draws only one of several squares in the same place.
  squares(points, size, paint) {
    const places = new Set(points.map(([x, y]) => `M${this.#at(x, y)}h0`))
    this.#put(`<path d="${[...places].join('')}" fill="none" stroke="${paint}" stroke-width="${size}" stroke-linecap="square"/>`)
  }

  #at(x, y) { return `${Math.round(10 * x) / 10} ${Math.round(10 * y) / 10}` }
  #put(element) {
    const list = this.globalCompositeOperation === 'destination-over' ? this.#under : this.#over
    list.push(this.#isClipped ? element.replace(' ', ' clip-path="url(#frame)" ') : element)
  }

  text() {
    const [width, height] = [this.width, this.height]
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="system-ui, sans-serif" font-size="13">
<clipPath id="frame"><path d="${this.#frame}"/></clipPath>
<rect width="${width}" height="${height}" fill="${colour('--paper')}"/>
${[...this.#under, ...this.#over].join('\n')}
</svg>
`
  }
}
