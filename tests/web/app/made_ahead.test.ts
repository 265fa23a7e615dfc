import { expect, it, vi } from "vitest";
import type { DownloadFormat, DownloadRequest } from "../../../web/src/app/files/formats";
import { MadeAhead, sizeInWords } from "../../../web/src/app/files/made_ahead";
import { NotFetched } from "../../../web/src/generate/files/exporter";
import type { PageModel } from "../../../web/src/models/page_model";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { toy } from "../toy";

const model = toy as unknown as PageModel;
const request: DownloadRequest = {
	plant: { model, grown: EMPTY_PLANT, from: fromPreset(model) },
	link: "?model=toy",
	name: "toy-1",
	options: { triangles: 500 },
};

function format(key: string, make: DownloadFormat["make"], sized = true): DownloadFormat {
	return { key, title: key, about: "", suffix: `.${key}`, sized, make };
}

const wanted = (formats: readonly DownloadFormat[]) => formats.map((each) => ({ format: each, request }));

it("makes one file after the other, each once, slow ones last", async () => {
	const order: string[] = [];
	const named = (key: string) =>
		format(key, async () => {
			order.push(key);
			return new Blob([key]);
		});
	const [one, two, unsized] = [named("one"), named("two"), format("png", async () => new Blob(), false)];
	const changed = vi.fn();
	const ahead = new MadeAhead(changed);
	expect(ahead.file(one, request)).toBeUndefined();
	const slow = { ...named("slow"), slow: true };
	await ahead.start(wanted([slow, one, two, unsized]));
	await ahead.start(wanted([slow, one, two, unsized]));
	expect(order).toEqual(["one", "two", "slow"]);
	expect(changed).toHaveBeenCalledTimes(3);
	expect(await ahead.file(two, request)?.text()).toBe("two");
	expect(ahead.file(unsized, request)).toBeUndefined();
});

it("returns a file only for the request and plant that it was made from", async () => {
	const one = format("one", async () => new Blob(["one"]));
	const ahead = new MadeAhead(() => undefined);
	await ahead.start(wanted([one]));
	expect(ahead.file(one, { ...request, options: { triangles: 600 } })).toBeUndefined();
	expect(ahead.file(one, { ...request, link: "?model=toy&seed=2" })).toBeUndefined();
	const grown = { ...EMPTY_PLANT };
	expect(ahead.file(one, { ...request, plant: { ...request.plant, grown } })).toBeUndefined();
	expect(ahead.file(one, { ...request, plant: { ...request.plant } })).toBeDefined();
	ahead.clear();
	expect(ahead.file(one, request)).toBeUndefined();
});

it("continues after a failed file, and stops on request", async () => {
	const broken = format("broken", async () => Promise.reject(new Error("no")));
	const ahead = new MadeAhead(() => undefined);
	const last = vi.fn(async () => new Blob(["last"]));
	const stopping = format("stopping", async (_, signal) => {
		ahead.stop();
		expect(signal?.aborted).toBe(true);
		return new Blob(["late"]);
	});
	await ahead.start(wanted([broken, stopping, format("last", last)]));
	expect(last).not.toHaveBeenCalled();
	expect(ahead.file(stopping, request)).toBeUndefined();
	await ahead.start(wanted([broken, format("last", last)]));
	expect(last).toHaveBeenCalledOnce();
	expect(ahead.file(broken, request)).toBeUndefined();
	expect(ahead.problem(broken, request)).toBe("no");
	expect(ahead.problem(broken, { ...request, options: {} })).toBeUndefined();
	expect(ahead.problem(format("last", last), request)).toBeUndefined();
});

it("stops if the script that makes files cannot be fetched", async () => {
	const last = vi.fn(async () => new Blob(["last"]));
	const ahead = new MadeAhead(() => undefined);
	await ahead.start(wanted([format("far", async () => Promise.reject(new NotFetched())), format("last", last)]));
	expect(last).not.toHaveBeenCalled();
});

it("formats file sizes in decimal units", () => {
	expect([1, 41_400, 999_400, 999_600, 2_927_000, 9_960_000, 28_461_000].map(sizeInWords)).toEqual([
		"1 kB",
		"41 kB",
		"999 kB",
		"1.0 MB",
		"2.9 MB",
		"10 MB",
		"28 MB",
	]);
});
