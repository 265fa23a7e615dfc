/** Runs in a page before its own scripts: the visitor has seen all hints. Pages of no origin have no storage. */
export function withoutHints() {
	try {
		localStorage.setItem("panicle.hints", '["point","turn","play"]');
	} catch {}
}
