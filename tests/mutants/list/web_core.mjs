/** The page's side of the core: workers, pool, container. */
const SRC = "web/src/core";
const TESTS = "tests/web/core";

export default [
	{
		file: `${SRC}/pool.ts`,
		suites: [`${TESTS}/pool.test.ts`, `${TESTS}/client.test.ts`, `${TESTS}/client_failures.test.ts`],
		faults: [
			{
				id: "pool-dead-spare-kept",
				find: "if (this.#spare === worker) this.#spare = undefined;",
				replace: "",
				breaks: "after a spare worker died, the next growth waits for ever",
			},
			{
				id: "pool-failed-module-kept",
				find: "this.#modules.delete(wasm);",
				replace: "",
				breaks: "a core that could not be fetched once is never asked for again",
			},
			{
				id: "pool-never-a-second-try",
				find: "const MAX_ATTEMPTS = 2;",
				replace: "const MAX_ATTEMPTS = 1;",
				breaks: "a worker that dies takes its growth with it",
			},
			{
				id: "pool-waiting-job-not-cancelled",
				find: "if (at >= 0) this.#waiting.splice(at, 1);",
				replace: "",
				breaks: "what was cancelled before it began grows all the same",
			},
			{
				id: "pool-last-comes-first",
				find: "this.#waiting.find(({ background }) => !background)",
				replace: "this.#waiting.findLast(({ background }) => !background)",
				breaks: "who waits longest waits on",
			},
			{
				id: "pool-late-answer-taken",
				find: "if (!job || message.id !== job.id) return;",
				replace: "if (!job) return;",
				breaks: "an old answer is taken for the newest",
			},
		],
	},
	{
		file: `${SRC}/page_pool.ts`,
		suites: [`${TESTS}/page_pool.test.ts`],
		faults: [
			{
				id: "page-pool-never-ends",
				find: "this.#pool?.close();",
				replace: "",
				breaks: "workers stay after the last plant of the page has gone",
			},
			{
				id: "page-pool-ends-in-use",
				find: "clearTimeout(this.#closing);",
				replace: "",
				breaks: "a growth is cancelled by the end of the use before it",
			},
			{
				id: "page-pool-for-each-user",
				find: "this.#pool ??= this.#start();",
				replace: "this.#pool = this.#start();",
				breaks: "each element of a page starts workers of its own",
			},
		],
	},
	{
		file: `${SRC}/client.ts`,
		suites: [`${TESTS}/client.test.ts`],
		faults: [
			{
				id: "client-queues-up",
				find: "if (this.#running < this.#concurrency) begin();",
				replace: "if (this.#running >= 0) begin();",
				breaks: "a drag queues up growths",
			},
			{
				id: "client-never-abreast",
				find: "if (this.#running < this.#concurrency) begin();",
				replace: "if (this.#running < 1) begin();",
				breaks: "a step of a drag waits for the step before",
			},
			{
				id: "client-superseded-never-told",
				find: "this.#takeWaiting()?.reject(new Superseded());\n\t\tconst abort",
				replace: "this.#takeWaiting();\n\t\tconst abort",
				breaks: "what was superseded is waited for for ever",
				hangs: true,
			},
			{
				id: "client-listeners-pile-up",
				find: "waiting?.ignoreSignal();",
				replace: "",
				breaks: "a long drag leaves a listener on its signal for each step",
			},
		],
	},
	{
		file: `${SRC}/pool_worker.ts`,
		suites: [`${TESTS}/pool_worker.test.ts`, `${TESTS}/pool.test.ts`],
		faults: [
			{
				id: "seat-uncloneable-waits",
				find: 'this.#die(text("worker_request_not_sent", { reason }));',
				replace: "",
				breaks: "a request that cannot be copied to a worker is waited for without end",
				hangs: true,
			},
			{
				id: "seat-heard-after-its-end",
				find: 'if (this.#hasEnded) return;\n\t\tif (message.type === "broken")',
				replace: 'if (message.type === "broken")',
				breaks: "a worker that was ended still answers",
			},
			{
				id: "seat-module-sent-each-time",
				find: "if (this.#sent.has(wasm)) return;",
				replace: "",
				breaks: "the core is started anew for every growth",
			},
		],
	},
	{
		file: `${SRC}/container.ts`,
		suites: [`${TESTS}/container.test.ts`, `${TESTS}/core.test.ts`],
		faults: [
			{
				id: "container-outside-unchecked",
				find: "if (data + bytes <= length) continue;",
				replace: "continue;",
				breaks: "large arrays are read from where they are not",
			},
			{
				id: "container-header-unchecked",
				find: "|| length !== bytes.length) throw",
				replace: ") throw",
				breaks: "half an answer is taken for a whole one",
			},
			{
				id: "container-kinds-unchecked",
				find: "if (column.element !== element) throw",
				replace: "if (false) throw",
				breaks: "whole numbers are read as fractions, without a word",
			},
		],
	},
	{
		file: `${SRC}/core.ts`,
		suites: [`${TESTS}/core.test.ts`],
		faults: [
			{
				id: "core-goes-on-after-a-trap",
				find: "this.#trapped = true;",
				replace: "",
				breaks: "a broken core is asked again and again",
			},
		],
	},
	{
		file: `${SRC}/loader.ts`,
		suites: [`${TESTS}/loader.test.ts`],
		faults: [
			{
				id: "loader-in-the-words-of-the-engine",
				find: "return WebAssembly.compile(bytes).catch(throwerOfNotACore(type));",
				replace: "return WebAssembly.compile(bytes);",
				breaks: "what is no core is told in the engine's words",
			},
			{
				id: "loader-status-unheeded",
				find: "if (response.ok) return response;",
				replace: "return response;",
				breaks: "an error page is compiled",
			},
		],
	},
	{
		file: "web/src/models/bunch/read_bunch_plant.ts",
		suites: ["tests/web/models/bunch/read_bunch_plant.test.ts"],
		faults: [
			{
				id: "read-places-without-z",
				find: "const [x, y, z] = places.subarray(3 * index, 3 * index + 3);",
				replace: "const [x, y, z] = [...places.subarray(3 * index, 3 * index + 2), 0];",
				breaks: "berries that are not there are marked in the wrong plane",
			},
			{
				id: "read-all-pressed",
				find: 'pressed: columns.uint8("berries.pressed"),',
				replace: 'pressed: columns.uint8("berries.pressed").fill(255),',
				breaks: "no berry has wax",
			},
			{
				id: "read-counts-swapped",
				find: "n: counts[2 * i],",
				replace: "n: counts[2 * i + 1],",
				breaks: "files name drops as counts of axes",
			},
		],
	},
	{
		file: "web/src/core/pool.ts",
		suites: ["tests/web/core/pool.test.ts"],
		faults: [
			{
				id: "pool-last-seat-keeps-memory",
				find: "(this.#memory.get(worker) ?? 0) <= MAX_MEMORY",
				replace: "true",
				breaks: "the page's last worker keeps the memory of its largest plant",
			},
		],
	},
	{
		file: "web/src/formats/limits.ts",
		suites: ["tests/web/formats/limits.test.ts"],
		faults: [
			{
				id: "export-instances-count-once",
				find: "bytes += copies * bytesOf(mesh);",
				replace: "bytes += bytesOf(mesh);",
				breaks: "a file of a million leaves is made until there is no memory left",
			},
		],
	},
	{
		file: "web/src/formats/text_buffer.ts",
		suites: ["tests/web/formats/limits.test.ts"],
		faults: [
			{
				id: "text-buffer-without-limit",
				find: "if (this.#complete + this.#length + bytes > this.most) throw new FileTooLargeError(undefined, this.most);",
				replace: "",
				breaks: "a text grows until there is no memory left",
			},
		],
	},
];
