import { expect, it } from "vitest";
import { wantedBy } from "../../../web/src/offline/wanted";

const scope = "https://plants.example/app/";
const wanted = (path: string, init: Partial<Pick<Request, "method" | "cache">> = {}) =>
	wantedBy({ url: new URL(path, scope).href, method: "GET", cache: "default", ...init }, scope);

it.each([
	["./", ""],
	["?v=2&preset=riesling#g=1", ""],
	["index.html?v=2", ""],
	["embed.html?preset=riesling", "embed.html"],
	["assets/a-1.js", "assets/a-1.js"],
])("takes %s for the file “%s”", (path, file) => {
	expect(wanted(path)).toEqual({ file });
});

it("knows specimens by their folder, however they are asked for", () => {
	expect(wanted("specimens/riesling.glb?seed=7")).toBe("specimen");
	expect(wanted("specimens/leaf/oak.svg", { method: "HEAD", cache: "no-store" })).toBe("specimen");
	expect(wanted("specimens.js")).toEqual({ file: "specimens.js" });
});

it.each([
	["what lies elsewhere", "/other/specimens/riesling.glb", {}],
	["what lies on another host", "https://other.example/app/", {}],
	["what is sent", "./", { method: "POST" }],
	["what is asked past all that is kept", "./", { cache: "no-store" }],
] as const)("leaves %s to the network", (_, path, init) => {
	expect(wanted(path, init)).toBeUndefined();
});
