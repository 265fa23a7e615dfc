/** Runs the accessibility rules of axe-core in a page. */
import { createRequire } from "node:module";
import type { Page } from "@playwright/test";
import type axe from "axe-core";

const { source } = createRequire(import.meta.url)("axe-core") as typeof axe;

/** WCAG 2.0 to 2.2, levels A and AA, and the practices that axe recommends beyond them. */
const TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

/**
 * Handles of flat views may be closer to each other than the least size of a target: their place is that of the plant's
 * outline, which WCAG 2.5.8 exempts as essential. A press takes the nearest of two that overlap, keys choose each of
 * them, and an enlarged view moves them apart.
 */
const EXEMPT = { "target-size": /\.handle|data-handle/ };

/**
 * Returns the violations of a page and its frames, a text for each element: the rule, the element and the remedy.
 * @param rules the rules to run, by their names in axe-core; all rules of the tags by default
 */
export async function violations(page: Page, rules?: readonly string[]): Promise<string[]> {
	for (const frame of page.frames()) {
		// By the protocol, which the page's security policy does not restrict.
		if (!(await frame.evaluate(() => "axe" in window))) await frame.evaluate(source);
	}
	const found = await page.evaluate(
		(runOnly) =>
			(window as unknown as { axe: typeof axe }).axe.run(document, {
				runOnly,
				resultTypes: ["violations"],
				// Style sheets of the same origin need no request.
				preload: false,
			}),
		rules ? { type: "rule" as const, values: [...rules] } : { type: "tag" as const, values: TAGS },
	);
	const isExempt = (id: string, html: string) => id in EXEMPT && EXEMPT[id as keyof typeof EXEMPT].test(html);
	return found.violations.flatMap(({ id, nodes }) =>
		nodes
			.filter(({ html }) => !isExempt(id, html))
			.map(
				({ target, html, failureSummary }) =>
					`${id}: ${target.join(" ")}\n  ${html.slice(0, 200)}\n  ${failureSummary?.replaceAll("\n", " ") ?? ""}`,
			),
	);
}
