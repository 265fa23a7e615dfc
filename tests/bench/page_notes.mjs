/** Notes that a page of the app takes for the benchmark: times of inputs and of their results. */

/**
 * Runs in the page before its own scripts: records events with their times in `window.notes`. `requested` and `ended` are
 * of workers, `grown` has the core's own milliseconds, `regrow` and `shown` are the studio's measures, `sent` is an
 * upload to the GPU and `drew` the last draw call of a frame.
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
			if (message.type === "grow") note("requested");
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
			if (name === "regrow" || name === "shown") note(name, { took: duration }, startTime + duration);
		}
	}).observe({ entryTypes: ["measure"] });
	// Whether the page shows that it is growing.
	let growing = false;
	new MutationObserver(() => {
		const now = document.querySelector(".growing") !== null;
		if (now !== growing) note(now ? "growing" : "calm");
		growing = now;
	}).observe(document, { childList: true, subtree: true });
}

/** Clears the notes. */
export const forget = (page) =>
	page.evaluate(() => {
		window.notes.splice(0);
	});

/**
 * Performs an action, waits until the resulting plant has been drawn, and returns the time of each stage in
 * milliseconds from the input's time stamp; undefined where nothing changed.
 */
export async function followed(page, act) {
	await finished(page);
	await forget(page);
	await act();
	const drawn = () => {
		const shown = window.notes.find(({ what }) => what === "shown" || what === "sent");
		return shown && window.notes.some(({ what, at }) => what === "drew" && at > shown.at);
	};
	await page.waitForFunction(drawn, undefined, { polling: 20, timeout: 10_000 }).catch(() => {});
	const done = await finished(page);
	return timesOf(await page.evaluate(() => window.notes), done);
}

/** Waits until the GPU has finished: reading a pixel waits for it. */
const finished = (page) =>
	page.evaluate(() => {
		const gl = document.querySelector("canvas.stage-surface").getContext("webgl2");
		gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
		return performance.now();
	});

function timesOf(notes, done) {
	const first = (kind, after = 0) => notes.find(({ what, at }) => what === kind && at >= after);
	const hand = first("hand");
	const requested = hand && first("requested", hand.at);
	const grown = requested && first("grown", requested.at);
	const regrow = grown && first("regrow", grown.at);
	if (!regrow) return undefined;
	const shown = first("shown", regrow.at);
	// Uploads and draws of a frame are adjacent, up to the next event or frame.
	const begun = notes.findIndex(({ what, at }) => what === "sent" && at > (shown?.at ?? regrow.at));
	const frame = notes.slice(begun < 0 ? notes.length : begun);
	const end = frame.findIndex(
		({ what, at }, i) =>
			!/sent|drew/.test(what) || (what === "sent" && frame[i - 1]?.what === "drew" && at - frame[i - 1].at > 30),
	);
	const sent = frame.slice(0, end < 0 ? undefined : end).filter(({ what }) => what === "sent");
	const last = frame.slice(0, end < 0 ? undefined : end).findLast(({ what }) => what === "drew");
	return {
		requested: requested.at - hand.at,
		core: grown.core,
		crossing: grown.at - requested.at - grown.core,
		buffers: regrow.at - hand.at,
		showing: shown?.took ?? Number.NaN,
		shown: shown ? shown.at - hand.at : Number.NaN,
		submitted: last ? last.at - hand.at : Number.NaN,
		drawn: done - hand.at,
		megabytes: grown.bytes / 1e6,
		sent: sent.reduce((sum, { bytes }) => sum + bytes, 0) / 1e6,
	};
}
