/** The app without a network, its next version, specimens in the service worker. */
const OFFLINE = "tests/web/offline";
const E2E = "tests/e2e/offline.spec.ts";

export default [
	{
		file: "web/src/offline/cached_app.ts",
		suites: [`${OFFLINE}/cached_app.test.ts`],
		faults: [
			{
				id: "offline-page-kept-first",
				find: "Object.keys(this.#options.built.files).filter((path) => path !== PAGE);",
				replace: "Object.keys(this.#options.built.files).reverse();",
				breaks: "an app of which half was fetched is opened without a network",
			},
			{
				id: "offline-takes-any-version",
				find: "integrity: this.#options.built.files[path],",
				replace: "",
				breaks: "a deploy at the wrong moment leaves a mixture of two versions",
			},
			{
				id: "offline-old-files-let-go",
				find: "if (found.every((script) => script === undefined))",
				replace: "if (found.length >= 0)",
				breaks: "a tab of the old version no longer finds its scripts",
			},
			{
				id: "offline-other-apps-swept",
				find: "name.startsWith(this.#prefix) && name !== this.#name",
				replace: "name !== this.#name",
				breaks: "what another app of the same host keeps is deleted",
			},
		],
	},
	{
		file: "web/src/offline/wanted.ts",
		suites: [`${OFFLINE}/wanted.test.ts`],
		faults: [
			{
				id: "offline-nothing-past-what-is-kept",
				find: ' || cache === "no-store"',
				replace: "",
				breaks: "a page that looks for a newer version is shown its own",
			},
		],
	},
	{
		file: "web/src/offline/register.ts",
		suites: [`${OFFLINE}/register.test.ts`],
		faults: [
			{
				id: "offline-cannot-be-turned-off",
				find: "return status === 404 || status === 410;",
				replace: "return status === 410;",
				breaks: "a host that deletes the worker shows its visitors the old app for ever",
			},
			{
				id: "offline-drives-out-the-hosts-worker",
				find: "if (worker && worker.scriptURL !== href) return undefined;",
				replace: "",
				breaks: "a site’s own worker is replaced by the app’s",
			},
		],
	},
	{
		file: "web/src/app/app_updater.ts",
		suites: ["tests/web/app/app_updater.test.ts"],
		faults: [
			{
				id: "renewal-keeps-against-the-wish",
				find: "!connection?.saveData",
				replace: "true",
				breaks: "who asks to be spared data has megabytes fetched",
			},
			{
				id: "renewal-offers-what-does-not-wait",
				find: "if (this.#registration?.waiting === next) this.#offer(",
				replace: "if (next) this.#offer(",
				breaks: "a new version is announced that failed to come",
			},
			{
				id: "renewal-stuck-with-what-is-kept",
				find: "if (navigator.serviceWorker.controller) await this.look();",
				replace: "",
				breaks: "where a host’s next version cannot be kept, its visitors have the old one for ever",
			},
			{
				id: "renewal-reloads-by-itself",
				find: "if (!active || !next) return;",
				replace:
					'navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());\n\t\tif (!active || !next) return;',
				breaks: "a tab is loaded again because another went over to the new version",
			},
		],
	},
	{
		file: "web/src/offline/service_worker.ts",
		suites: [`${E2E}: a new version is offered`],
		faults: [
			{
				id: "offline-new-version-forced",
				find: "if (!(await app.isOtherWhole())) return worker.skipWaiting();",
				replace: "await worker.skipWaiting();",
				breaks: "a new version takes over in the middle of a session",
			},
			{
				id: "offline-open-tabs-forgotten",
				find: "(name?.startsWith(scope) ? [name] : [])",
				replace: "(name === scope ? [name] : [])",
				breaks: "what an open tab has not asked for yet is gone after another tab went over to the new version",
			},
		],
	},
	{
		file: "web/src/offline/specimens.ts",
		suites: [`${E2E}: a page of the same host has specimens`],
		faults: [
			{
				id: "offline-no-specimens",
				find: "panicleSpecimens = makeSpecimens;",
				replace: "panicleSpecimen = makeSpecimens;",
				breaks: "no address of a specimen is answered in the browser",
			},
		],
	},
	{
		file: "web/src/core/hold_scripts.ts",
		suites: ["tests/web/core/hold_scripts.test.ts"],
		faults: [
			{
				id: "offline-lock-let-go",
				find: "() => new Promise(() => {})",
				replace: "async () => {}",
				breaks: "an update deletes scripts that an open page has yet to fetch",
			},
		],
	},
	{
		file: "web/src/offline/page_growth.ts",
		suites: ["tests/web/offline/page_growth.test.ts"],
		faults: [
			{
				id: "offline-no-page-grows",
				find: "data === FREE && settle(port1)",
				replace: "data === GROWTH_NEEDED && settle(port1)",
				breaks: "the service worker grows specimens itself, and the app's files wait",
			},
		],
	},
	{
		file: "web/src/offline/specimen_queue.ts",
		suites: ["tests/web/offline/specimen_queue.test.ts"],
		faults: [
			{
				id: "offline-growth-without-end",
				find: "this.#timer = setTimeout(() => this.#break(refusal(late)), LONGEST_GROWTH);",
				replace: "",
				breaks: "a specimen that never ends keeps all others waiting",
			},
			{
				id: "offline-ended-worker-answers",
				find: "if (isCurrent()) this.#answer(data);",
				replace: "this.#answer(data);",
				breaks: "a specimen is answered with the file of another whose worker was ended",
			},
			{
				id: "offline-queue-unlimited",
				find: "this.#waiting.length >= MAX_WAITING",
				replace: "false",
				breaks: "requests for specimens pile up without a limit",
				hangs: true,
			},
		],
	},
];
