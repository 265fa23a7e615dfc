/** The package as users install it, in Node; package.long.test.ts has the rest, tests/e2e/package.spec.ts the browsers. */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { makePackage } from "../../wasm-core/tools/package/make.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { grow as growByCommand } from "../web/cli/world";
import { filesOfPage, type Project, projectWith } from "./project";

let project: Project;
beforeAll(async () => {
	project = await projectWith(await filesOfPage());
});
afterAll(() => project.remove());

it("grows the same plant as the command line, in a thread of its own", async () => {
	const { json } = await growByCommand(["riesling", "--seed", "7", "--set", "age=80"]);
	expect(project.run("many.mjs")).toMatch(
		new RegExp(`^[\\d.]+ cm long, with ${json.counts.berries} berries ${json.fingerprint} true\n$`),
	);
});

it("has its interface described in docs/api, which is up to date with its comments", async () => {
	const { pages } = await makePackage();
	for (const [name, text] of Object.entries(pages))
		expect(await readFile(join(repository, `docs/api/${name}.md`), "utf8"), "run `npm run docs -- api`").toBe(text);
});
