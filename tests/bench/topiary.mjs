/** Topiaries: time to grow one again, as when an area is moved. */
import { grower, nativeGrow } from "./core.mjs";
import { microseconds, printTable } from "./statistics.mjs";

const RUNS = 7;
const milliseconds = (micro) => (micro / 1000).toFixed(1);

export async function benchTopiaries({ core, source }) {
	const { writeContainer } = await source("web/src/core/container.ts");
	const { fromPreset } = await source("web/src/specimen/from_preset.ts");
	const { model } = await source("web/src/models/grammar/index.ts");
	const { TEXTS } = await source("web/src/models/grammar/texts.generated.ts");
	const rows = [["topiary", "aim ms", "a step of a drag, wasm ms", "native ms", "ratio", "whole, with sky, wasm ms"]];
	for (const { name, text } of model.presets.list.filter(({ kind }) => kind === "topiary")) {
		const specimen = { ...fromPreset(model, name), grammar: TEXTS[text] };
		const request = (options) => writeContainer(model.encode(specimen, options));
		const preview = request({ preview: true });
		const wasm = microseconds(1, RUNS, grower(core, preview));
		const native = nativeGrow(preview, 1, RUNS);
		const whole = microseconds(1, RUNS, grower(core, request()));
		const aim = name.endsWith("garden-tree") ? 50 : "–";
		rows.push([
			name.replace("topiary-", ""),
			aim,
			milliseconds(wasm),
			milliseconds(native),
			(wasm / native).toFixed(2),
			milliseconds(whole),
		]);
	}
	printTable("Topiaries, with meshes", rows);
}
