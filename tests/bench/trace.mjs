/** Reads tasks of the page's thread from a Chromium trace. */

/**
 * The tasks of the busiest page's thread, the longest first: milliseconds of its own time, and, where the profiler ran, how
 * much of it each function took.
 */
export function tasksOf(events) {
	const threads = new Set(
		events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain").map(threadOf),
	);
	const tasks = events.filter(
		// Tasks in progress at the trace's beginning or end have no duration.
		(event) => event.ph === "X" && event.tdur >= 0 && /RunTask$/.test(event.name) && threads.has(threadOf(event)),
	);
	const own = outermost(busiest(tasks));
	const samples = samplesOf(events, own[0] && threadOf(own[0]));
	return own
		.map(({ ts, dur, tdur }) => ({ milliseconds: tdur / 1000, from: ts, to: ts + dur, samples }))
		.sort((a, b) => b.milliseconds - a.milliseconds);
}

/** "draw 5.1, show 3.0": the functions that took most of a task, in milliseconds. */
export function heaviestIn({ from, to, samples }, count = 4) {
	const spent = new Map();
	for (const { at, lasted, name } of samples) {
		if (at >= from && at <= to) spent.set(name, (spent.get(name) ?? 0) + lasted);
	}
	const most = [...spent].sort(([, a], [, b]) => b - a).slice(0, count);
	return most.map(([name, lasted]) => `${name} ${(lasted / 1000).toFixed(1)}`).join(", ");
}

const threadOf = ({ pid, tid }) => `${pid}:${tid}`;

function busiest(tasks) {
	const byThread = new Map();
	for (const task of tasks) {
		const thread = threadOf(task);
		if (!byThread.has(thread)) byThread.set(thread, []);
		byThread.get(thread).push(task);
	}
	const total = (own) => own.reduce((sum, { tdur }) => sum + tdur, 0);
	return [...byThread.values()].sort((a, b) => total(b) - total(a))[0] ?? [];
}

/** Two layers of Chromium report the same task: the outer one counts. */
function outermost(tasks) {
	let end = 0;
	return tasks
		.sort((a, b) => a.ts - b.ts || b.dur - a.dur)
		.filter(({ ts, dur }) => {
			const inner = ts < end;
			end = Math.max(end, ts + dur);
			return !inner;
		});
}

/** Samples of a thread: times and stacks. */
function samplesOf(events, thread) {
	const names = new Map();
	const samples = [];
	const begun = new Map();
	for (const event of events) {
		if (event.name === "Profile" && threadOf(event) === thread)
			begun.set(`${event.pid}:${event.id}`, event.args.data.startTime);
	}
	for (const { name, id, pid, args } of events) {
		const profile = `${pid}:${id}`;
		if (name !== "ProfileChunk" || !begun.has(profile)) continue;
		const { cpuProfile = {}, timeDeltas = [] } = args.data;
		for (const { id: node, callFrame } of cpuProfile.nodes ?? []) {
			names.set(`${profile}:${node}`, callFrame.functionName || "(unnamed)");
		}
		(cpuProfile.samples ?? []).forEach((node, i) => {
			const at = begun.get(profile) + timeDeltas[i];
			begun.set(profile, at);
			const last = samples.at(-1);
			if (last) last.lasted = timeDeltas[i];
			samples.push({ at, lasted: 0, name: names.get(`${profile}:${node}`) ?? "(unknown)" });
		});
	}
	return samples;
}
