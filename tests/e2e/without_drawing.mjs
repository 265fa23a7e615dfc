/**
 * Runs in a page before its own scripts: WebGL draws, copies and clears do nothing; buffers, textures and programs are
 * uploaded as usual. Software drawing would dominate the costs of a page.
 */
export function withoutDrawing() {
	const drawing = ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced", "drawRangeElements"];
	const pixels = ["clear", "blitFramebuffer", "copyTexSubImage2D", "generateMipmap"];
	for (const name of [...drawing, ...pixels]) WebGL2RenderingContext.prototype[name] = () => {};
}
