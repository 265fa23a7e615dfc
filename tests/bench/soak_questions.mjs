/** The requests of `npm run bench -- soak`, by number: the same for the same number. Most plants are small, for there are many requests. */
import { deflateRawSync } from "node:zlib";

const BUNCHES = ["riesling", "merlot", "long-conical", "short-conical", "lychee", "rubus", "redcurrant", "grape-15a"];
const PAPERS = ["short-conical", "long-conical", "cylindrical", "grape-15b", "grape-15c"];
const FILES = ["glb", "web.glb", "low.glb", "instanced.glb", "growth.glb", "usdz", "obj", "mtl", "obj.zip"];
const MORE_FILES = ["ply", "stl", "3mf", "csv", "json"];
const OTHERS = [
	"root/carrot.json?n=100",
	"root/tap.json?n=100",
	"leaf/oak.json?n=100",
	"leaf/grapevine.json?n=100",
	"tree/birch.json?n=100",
	"flower/buttercup.json?age=0.5&file-map=0",
	"flower/petal.json?smooth=0",
	"flower/crocus.glb?smooth=0",
	"growth/table-1-star.json?steps=4",
];
const BAD = [
	"specimens/nettle.glb",
	"specimens/fern/oak.glb",
	"specimens/riesling",
	"specimens/riesling.doc",
	"specimens/riesling.png",
	"specimens/%E0%A4%A.glb",
	"specimens/riesling.json?colour=red",
	"specimens/riesling.json?age=9000",
	"specimens/riesling.low.glb?file-triangles=many",
	`specimens/riesling.glb?seed=${"1".repeat(25_000)}`,
	"elsewhere/riesling.glb",
];

const packed = (text) => deflateRawSync(text).toString("base64url");
const of = (list, i) => list[Math.floor(i) % list.length];

/** By the last digits of the number. */
const KINDS = [
	(i) => `specimens/redcurrant.json?file-measures=0&count=${5 + (i % 26)}&seed=${i}`,
	(i) => `specimens/redcurrant.json?count=${5 + (i % 26)}&seed=${i}`,
	(i) => `specimens/${of(BUNCHES, i / 20)}.json?file-measures=0&count=${20 + (i % 41)}&seed=${i}`,
	(i) => `specimens/paper.json?v=1&preset=${of(PAPERS, i / 20)}&seed=${i}`,
	(i) => (i % 50 < 10 ? `specimens/${of(OTHERS, i / 50)}&seed=${i}` : `specimens/redcurrant.json?seed=${i}.5&count=9`),
	(i) => `specimens/own.json?v=2&g=${packed(`axiom: F(0.${i})\n`)}`,
	(i) => `specimens/own.json?v=2&g=${packed(`axiom: F(0.${i}\n`)}`,
	(i) => of(BAD, i / 20),
	(i) => `specimens/redcurrant.${of(i % 40 < 20 ? FILES : MORE_FILES, i / 40)}?count=5&seed=${i % 400}`,
	(i) => `specimens/link.json?v=2&preset=redcurrant&count=${i % 20}&age=${i}&colour=red&m=${"9".repeat(i % 50)}`,
];
const METHODS = ["GET", "GET", "GET", "HEAD", "GET", "OPTIONS", "GET", "GET", "POST", "GET"];

/** @returns {{ path: string, method: string, headers: Record<string, string> }} */
export function soakQuestion(i) {
	const path = `/${KINDS[i % KINDS.length](i)}`;
	const again = i % 11 === 0;
	return { path, method: METHODS[Math.floor(i / 10) % METHODS.length], headers: again ? { "if-none-match": "*" } : {} };
}
