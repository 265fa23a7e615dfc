/** Scripts that do one of several tasks, by name: `npm run pictures -- gallery`, `npm run bench -- fit`. */

/**
 * @typedef {object} Task
 * @property {string} about one line for the list, without a full stop
 * @property {string} [words] the words that the task takes after its name, for the list: `[MODEL …]`
 * @property {(words: string[]) => unknown} run
 */

/**
 * The list of tasks as text, one per line, in columns.
 *
 * @param {string} script name of the npm script
 * @param {Readonly<Record<string, Task>>} tasks
 */
export function listOfTasks(script, tasks) {
	const rows = Object.entries(tasks).map(([name, { words, about }]) => [words ? `${name} ${words}` : name, about]);
	const width = Math.max(...rows.map(([call]) => call.length));
	const lines = rows.map(([call, about]) => `  ${call.padEnd(width)}  ${about}`);
	return [`npm run ${script} -- NAME`, ...lines].join("\n");
}

/**
 * Runs the task that the first word names, with the other words. Without a name (no words, or an option first) runs
 * `standard`, or prints the list of tasks if there is no `standard`. An unknown name prints the list to standard error and
 * sets exit status 2.
 *
 * @param {string} script name of the npm script
 * @param {Readonly<Record<string, Task>>} tasks
 * @param {string[]} words
 * @param {{ standard?: () => unknown }} [options]
 */
export async function runTask(script, tasks, words, { standard } = {}) {
	const [name, ...rest] = words;
	const named = name !== undefined && !name.startsWith("--");
	if (!named && standard && name !== "--help") await standard();
	else if (!named) console.log(listOfTasks(script, tasks));
	else if (Object.hasOwn(tasks, name)) await tasks[name].run(rest);
	else {
		console.error(`No task “${name}”.\n${listOfTasks(script, tasks)}`);
		process.exitCode = 2;
	}
}
