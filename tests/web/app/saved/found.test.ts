import { expect, it } from "vitest";
import { findSaved } from "../../../../web/src/app/saved/found";
import { savedAs } from "./saved_store";

const all = [savedAs("Beta 10", { at: 3 }), savedAs("Crémant", { at: 1 }), savedAs("beta 9", { at: 2 })];
const find = (query: string, order: "newest" | "oldest" | "name" = "newest") =>
	findSaved(all, query, order, ({ at }) => (at === 1 ? "Leaf Maple" : "Bunch")).map(({ name }) => name);

it("finds saved specimens by words of name, model and preset, ignoring case and accents", () => {
	expect(find("cremant")).toEqual(["Crémant"]);
	expect(find("MAPLE cre")).toEqual(["Crémant"]);
	expect(find("bunch beta")).toEqual(["Beta 10", "beta 9"]);
	expect(find("maple beta")).toEqual([]);
});

it("forgives plurals, other names and typos where nothing is found otherwise", () => {
	expect(find("cremants")).toEqual(["Crémant"]);
	expect(find("cermant")).toEqual(["Crémant"]);
	expect(find("betta")).toEqual(["Beta 10", "beta 9"]);
	expect(find("acer")).toEqual(["Crémant"]);
	expect(find("betax crémant")).toEqual([]);
});

it("sorts by date and by name, numbers as numbers", () => {
	expect(find("")).toEqual(["Beta 10", "beta 9", "Crémant"]);
	expect(find("", "oldest")).toEqual(["Crémant", "beta 9", "Beta 10"]);
	expect(find("", "name")).toEqual(["beta 9", "Beta 10", "Crémant"]);
});
