/** The service in Node: limits per client. */
const NODE = "web/src/service/node";

export default [
	{
		file: `${NODE}/thread_pool.ts`,
		suites: ["tests/web/service/node/thread_pool.test.ts"],
		faults: [
			{
				id: "service-thread-keeps-memory",
				find: "if (response.heapBytes <= this.#options.mostHeapBytes) ",
				replace: "",
				breaks: "a thread that has grown a large plant keeps its memory for as long as the service runs",
			},
			{
				id: "service-client-stays-in-queue",
				find: "this.#dequeue(job, new Refused(503, why));\n\t\tconst slot",
				replace: "const slot",
				breaks: "requests of clients that have left keep their places in the queue",
			},
			{
				id: "service-grows-after-client-left",
				find: "Math.min(ABANDONED_TIMEOUT, this.#options.timeout)",
				replace: "this.#options.timeout",
				breaks: "a growth goes on for a client that has left",
			},
			{
				id: "service-waits-without-end",
				find: "job.waiting = setTimeout(() => this.#dequeue(job, late), timeout);",
				replace: "void late;",
				breaks: "a request waits in the queue for as long as there are others before it",
			},
			{
				id: "service-drains-nothing",
				find: "await Promise.allSettled(this.#pending);",
				replace: "",
				breaks: "answers that are due are lost when the service ends",
			},
		],
	},
	{
		file: `${NODE}/server.ts`,
		suites: ["tests/web/service/node/server.test.ts"],
		faults: [
			{
				id: "service-passes-on-passwords",
				find: 'address.username = "";\n\taddress.password = "";',
				replace: "",
				breaks: "an address with a user and password ends the thread that answers it",
			},
			{
				id: "service-passes-on-any-method",
				find: "if (!METHODS.includes(method))",
				replace: 'if (method === "")',
				breaks: "methods that no Request can have reach the threads",
			},
			{
				id: "service-waits-for-stalled-readers",
				find: "response.setTimeout(limits.stalled, drop);",
				replace: "",
				breaks: "a client that reads nothing holds its answer until the deadline of its size",
			},
			{
				id: "service-waits-for-slow-readers",
				find: "const deadline = setTimeout(drop, limits.stalled + (1000 * body.byteLength) / limits.slowest);",
				replace: "const deadline = setTimeout(() => {}, 0);",
				breaks: "a client that reads a byte a second holds its answer for days",
			},
			{
				id: "service-holds-any-number-of-answers",
				find: "if (unread > limits.unread)",
				replace: "if (unread < 0)",
				breaks: "answers that clients have yet to read take any memory",
			},
			{
				id: "service-counts-answers-of-clients-that-left",
				find: "if (left.aborted) return;",
				replace: "",
				breaks: "after many requests whose clients left early the service refuses all others",
			},
			{
				id: "service-keeps-silent-connections",
				find: "server.timeout = limits.request;",
				replace: "server.timeout = 0;",
				breaks: "connections that send nothing stay open",
			},
			{
				id: "service-takes-any-connections",
				find: "server.maxConnections = limits.connections;",
				replace: "",
				breaks: "clients open any number of connections",
			},
		],
	},
];
