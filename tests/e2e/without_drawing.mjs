/**
 * In a page, before its own scripts: nothing is drawn, copied or cleared; buffers, textures and programs are sent as ever. What
 * software draws would be most of what a page costs.
 */
export function withoutDrawing() {
	const drawing = ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced", "drawRangeElements"];
	const pixels = ["clear", "blitFramebuffer", "copyTexSubImage2D", "generateMipmap"];
	for (const name of [...drawing, ...pixels]) WebGL2RenderingContext.prototype[name] = () => {};
}
