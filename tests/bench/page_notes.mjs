/** What a page of the app notes of itself for the bench: when a hand did something, and when what followed from it came. */

/**
 * In the page, before its own scripts: keeps in `window.notes` what happened and when. `asked` and `ended` are of workers, `grown`
 * has the core's own milliseconds, `regrow` and `laid` are the studio's measures, `sent` is a buffer on its way to the
 * graphics card and `drew` the last thing that a frame asked it for.
 */
export function noteAll() {
	const notes = [];
	window.notes = notes;
	const note = (what, more = {}, at = performance.now()) => notes.push({ what, at, ...more });
	const { bufferData, drawElements, drawElementsInstanced } = WebGL2RenderingContext.prototype;
	Object.assign(WebGL2RenderingContext.prototype, {
		bufferData(...given) {
			note("sent", { bytes: given[1]?.byteLength ?? 0 });
			return bufferData.apply(this, given);
		},
		drawElements(...given) {
			drawElements.apply(this, given);
			note("drew");
		},
		drawElementsInstanced(...given) {
			drawElementsInstanced.apply(this, given);
			note("drew");
		},
	});
	window.Worker = class extends Worker {
		constructor(...given) {
			super(...given);
			this.addEventListener("message", ({ data }) => {
				if (data.type === "grown") note("grown", { core: data.milliseconds, bytes: data.container.byteLength });
			});
		}
		postMessage(message, ...rest) {
			super.postMessage(message, ...rest);
			if (message.type === "grow") note("asked");
		}
		terminate() {
			super.terminate();
			note("ended");
		}
	};
	for (const kind of ["keydown", "pointermove", "click"])
		window.addEventListener(kind, ({ timeStamp }) => note("hand", {}, timeStamp), { capture: true });
	new PerformanceObserver((list) => {
		for (const { name, startTime, duration } of list.getEntries()) {
			if (name === "regrow" || name === "laid") note(name, { took: duration }, startTime + duration);
		}
	}).observe({ entryTypes: ["measure"] });
	// Whether the page says that it grows.
	let growing = false;
	new MutationObserver(() => {
		const now = document.querySelector(".growing") !== null;
		if (now !== growing) note(now ? "growing" : "calm");
		growing = now;
	}).observe(document, { childList: true, subtree: true });
}

/** Forgets what was noted. */
export const forget = (page) =>
	page.evaluate(() => {
		window.notes.splice(0);
	});

/**
 * Does something with the hand, waits until the plant that follows has been drawn, and tells how long what took, in milliseconds
 * from the hand's own time stamp on; undefined where nothing followed.
 */
export async function followed(page, act) {
	await finished(page);
	await forget(page);
	await act();
	const drawn = () => {
		const laid = window.notes.find(({ what }) => what === "laid" || what === "sent");
		return laid && window.notes.some(({ what, at }) => what === "drew" && at > laid.at);
	};
	await page.waitForFunction(drawn, undefined, { polling: 20, timeout: 10_000 }).catch(() => {});
	const done = await finished(page);
	return timesOf(await page.evaluate(() => window.notes), done);
}

/** When all that was asked of the graphics card is done: a pixel that is read back waits for it. */
const finished = (page) =>
	page.evaluate(() => {
		const gl = document.querySelector("canvas.stage-surface").getContext("webgl2");
		gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
		return performance.now();
	});

function timesOf(notes, done) {
	const first = (kind, after = 0) => notes.find(({ what, at }) => what === kind && at >= after);
	const hand = first("hand");
	const asked = hand && first("asked", hand.at);
	const grown = asked && first("grown", asked.at);
	const regrow = grown && first("regrow", grown.at);
	if (!regrow) return undefined;
	const laid = first("laid", regrow.at);
	// What a frame sends and draws stands together, up to the next thing that happens or the next frame.
	const begun = notes.findIndex(({ what, at }) => what === "sent" && at > (laid?.at ?? regrow.at));
	const frame = notes.slice(begun < 0 ? notes.length : begun);
	const end = frame.findIndex(
		({ what, at }, i) =>
			!/sent|drew/.test(what) || (what === "sent" && frame[i - 1]?.what === "drew" && at - frame[i - 1].at > 30),
	);
	const sent = frame.slice(0, end < 0 ? undefined : end).filter(({ what }) => what === "sent");
	const last = frame.slice(0, end < 0 ? undefined : end).findLast(({ what }) => what === "drew");
	return {
		asked: asked.at - hand.at,
		core: grown.core,
		crossing: grown.at - asked.at - grown.core,
		buffers: regrow.at - hand.at,
		laying: laid?.took ?? Number.NaN,
		laid: laid ? laid.at - hand.at : Number.NaN,
		submitted: last ? last.at - hand.at : Number.NaN,
		drawn: done - hand.at,
		megabytes: grown.bytes / 1e6,
		sent: sent.reduce((sum, { bytes }) => sum + bytes, 0) / 1e6,
	};
}
