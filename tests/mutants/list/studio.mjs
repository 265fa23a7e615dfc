/** The page's state and its changes. */
const SRC = "web/src/app";
const TESTS = "tests/web/app";

export default [
	{
		file: `${SRC}/studio.ts`,
		suites: [`${TESTS}/studio.test.ts`, `${TESTS}/studio_models.test.ts`],
		faults: [
			{
				id: "studio-brief-notices-stay",
				find: "if (options.brief) setTimeout(() => this.dismiss(id), BRIEF);",
				replace: "",
				breaks: "“Link copied” stays for ever",
			},
			{
				id: "studio-failure-stays",
				find: "this.#update({ shown: { model, grown, from }, measures, failure: undefined });",
				replace: "this.#update({ shown: { model, grown, from }, measures });",
				breaks: "“This cannot be grown” stands before a bunch that has grown",
			},
			{
				id: "studio-notes-unsaid",
				find: "if (lines.length > 0) this.notify(",
				replace: "if (lines.length > 99) this.notify(",
				breaks: "nothing says what of a link could not be used",
			},
			{
				id: "studio-drag-measured-at-every-step",
				find: "{ preview: held }",
				replace: "{ preview: false }",
				breaks: "every step of a drag is measured, and slow",
			},
			{
				id: "studio-never-measured-after-a-drag",
				find: "|| (!this.#state.held && !this.#isMeasured)) this.#requestGrowth();",
				replace: ") this.#requestGrowth();",
				breaks: "the numbers stay those from before a drag",
			},
			{
				id: "studio-colours-grow",
				find: "if (!growsAlike(before, present) ||",
				replace: "if (true ||",
				breaks: "every colour regrows the bunch",
			},
			{
				id: "studio-tools-never-end",
				find: "for (const end of this.#ends.splice(0)) end();",
				replace: "",
				breaks: "a life goes on playing with another model",
			},
			{
				id: "studio-address-not-settled",
				find: "this.#services.settled(this.#state.model, this.#state.specimen);",
				replace: "",
				breaks: "the address bar keeps the bunch it opened with",
			},
		],
	},
	{
		file: `${SRC}/address.ts`,
		suites: [`${TESTS}/address.test.ts`],
		faults: [
			{
				id: "address-older-after-newer",
				find: "if (this.#newest !== specimen) return;",
				replace: "",
				breaks: "a slow packing puts an older bunch into the address bar",
			},
			{
				id: "address-throws-when-full",
				find: "} catch {\n\t\t\t// Browsers",
				replace: "} catch (error) {\n\t\t\tthrow error;\n\t\t\t// Browsers",
				breaks: "playing a life ends in an error of the browser's",
			},
		],
	},
	{
		file: `${SRC}/growing.ts`,
		suites: [`${TESTS}/growing.test.ts`],
		faults: [
			{
				id: "growing-sketch-stays",
				find: "sketch.catch(() => {});\n\t\tstudio.growAgain();",
				replace: "sketch.catch(() => {});",
				breaks: "the opening bunch keeps the few triangles of its first leaves",
			},
			{
				id: "growing-sketches-for-ever",
				find: "this.#opening = false;",
				replace: "",
				breaks: "leaves stay sketches after every change",
			},
			{
				id: "growing-older-after-newer",
				find: "if (turn < this.#shown) return;",
				replace: "",
				breaks: "a slow answer puts an older bunch back",
			},
			{
				id: "growing-superseded-is-a-failure",
				find: "if (error instanceof Superseded) return;",
				replace: "",
				breaks: "every drag ends in an error",
			},
			{
				id: "growing-says-so-for-ever",
				find: "this.#studio().setGrowing(false);",
				replace: "",
				breaks: "“Growing” stays over the picture",
			},
		],
	},
	{
		file: `${SRC}/ui_state.ts`,
		suites: [`${TESTS}/ui_state.test.ts`],
		faults: [
			{
				id: "ui-any-theme",
				find: 'theme: theme === "light" || theme === "dark" ? theme : "system",',
				replace: 'theme: theme as UiState["theme"],',
				breaks: "a spoiled storage spoils the page",
			},
		],
	},
	{
		file: `${SRC}/panel_groups.ts`,
		suites: [`${TESTS}/panel_groups.test.ts`],
		faults: [
			{
				id: "panel-shows-what-is-unheeded",
				find: "table.isActive(specimen, entry) && ",
				replace: "",
				breaks: "sliders that do nothing are shown",
			},
			{
				id: "panel-empty-groups",
				find: ".filter(({ entries, above, below }) => entries.length + above.length + below.length > 0)",
				replace: "",
				breaks: "empty groups are shown",
			},
		],
	},
	{
		file: `${SRC}/search/words.ts`,
		suites: [`${TESTS}/search/words.test.ts`],
		faults: [
			{
				id: "search-accents-matter",
				find: '.replace(/\\p{M}/gu, "")',
				replace: "",
				breaks: "gewurztraminer finds no Gewürztraminer",
			},
		],
	},
	{
		file: "web/src/ui/change.ts",
		suites: ["tests/web/ui/change.test.ts"],
		faults: [
			{
				id: "change-same-seed-again",
				find: "return drawn === seed ? (drawn % SEEDS_DRAWN) + 1 : drawn;",
				replace: "return drawn;",
				breaks: "“New variation” may show the same",
			},
		],
	},
	{
		file: `${SRC}/files/made_ahead.ts`,
		suites: [`${TESTS}/made_ahead.test.ts`],
		faults: [
			{
				id: "made-ahead-of-another-plant",
				find: "known?.grown === request.plant.grown ? known.file : undefined",
				replace: "known?.file",
				breaks: "a file is of the plant that was there when the menu opened",
			},
		],
	},
	{
		file: `${SRC}/files/formats.ts`,
		suites: [`${TESTS}/formats.test.ts`],
		faults: [
			{
				id: "formats-instances-of-anything",
				find: "!shared || hasInstances(shown)",
				replace: "true",
				breaks: "an instanced GLB is offered that is no other file",
			},
			{
				id: "formats-of-no-use",
				find: "applies?.(grown) ?? true",
				replace: "applies === undefined || true",
				breaks: "files are offered that do not suit the plant",
			},
		],
	},
	{
		file: "web/src/app/notice_list.ts",
		suites: ["tests/web/app/studio.test.ts"],
		faults: [
			{
				id: "studio-warns-of-what-is-no-more",
				find: "notices.some(({ untouched }) => untouched) ?",
				replace: "notices.length < 0 ?",
				breaks: "what was said of a link stands there after the document has changed",
			},
			{
				id: "studio-same-words-stack",
				find: ".filter(({ title }) => title !== notice.title);",
				replace: ";",
				breaks: "the same notice stands there three times",
			},
			{
				id: "studio-notices-without-end",
				find: ".slice(-MAX_NOTICES)",
				replace: "",
				breaks: "notices cover the page",
			},
		],
	},
	{
		file: `${SRC}/shortcuts.ts`,
		suites: ["tests/e2e/trouble.spec.ts: a long growth says so"],
		faults: [
			{
				id: "studio-escape-cancels-nothing",
				find: 'event.key === "Escape" && studio.state.growing',
				replace: "false",
				breaks: "what takes long to grow cannot be cancelled by a key",
			},
		],
	},
	{
		file: `${SRC}/files/purposes.ts`,
		suites: [`${TESTS}/purposes.test.ts`],
		faults: [
			{
				id: "studio-download-recommends-impossible-file",
				find: "suitable.find(canMake) ?? suitable[0]",
				replace: "suitable[0]",
				breaks: "the download sheet recommends a file that is too large to be made",
			},
		],
	},
	{
		file: `${SRC}/parts/gallery.ts`,
		suites: [`${TESTS}/parts/escape.test.ts`],
		faults: [
			{
				id: "studio-escape-from-presets-goes-on",
				find: 'event.preventDefault();\n\t\t\tthis.querySelector<HTMLElement>(".find button")?.focus();',
				replace: 'this.querySelector<HTMLElement>(".find button")?.focus();',
				breaks: "who leaves the strip of presets by Escape loses the chosen plant",
			},
		],
	},
	{
		file: `${SRC}/search/text_index.ts`,
		suites: [`${TESTS}/preset_search.test.ts`],
		faults: [
			{
				id: "search-typos-beside-matches",
				find: "exact.size > 0 || !forgives ? exact : this.#scoresOf(words, true)",
				replace: "this.#scoresOf(words, true)",
				breaks: "a search for a pine lists vines",
			},
			{
				id: "search-titles-like-descriptions",
				find: "level * LEVEL + cost",
				replace: "cost",
				breaks: "plants whose description has the word come before those of that name",
			},
			{
				id: "search-any-word",
				find: "if (other !== undefined) both.set(at, join(score, other));",
				replace: "both.set(at, join(score, other ?? 0));",
				breaks: "a search for two words finds plants with one of them",
			},
		],
	},
	{
		file: `${SRC}/search/words.ts`,
		suites: [`${TESTS}/search/words.test.ts`],
		faults: [
			{
				id: "search-exchange-is-two-typos",
				find: "short[from] === long[from + 1] && short[from + 1] === long[from]",
				replace: "false",
				breaks: "two letters in the wrong order find nothing",
			},
		],
	},
	{
		file: `${SRC}/palette/entries.ts`,
		suites: [`${TESTS}/palette/search.test.ts`],
		faults: [
			{
				id: "palette-offers-what-cannot-run",
				find: 'key !== "palette" && (isAvailable?.(studio) ?? true)',
				replace: 'key !== "palette"',
				breaks: "the palette offers to undo where there is no step",
			},
		],
	},
];
