/** Refuses a parameter table that would make wrong code; each message names the parameter. */

const requiredOfAll = ["key", "link", "label", "group", "kind", "help", "since"];

/**
 * Lists what is wrong with a parameter, each as the end of a sentence about it. `groups` holds the keys of known
 * groups.
 */
function problemsOf(parameter, groups) {
	const problems = requiredOfAll.filter((field) => parameter[field] === undefined).map((field) => `has no ${field}`);
	if (!/^[a-z][a-z0-9_]*$/.test(parameter.key ?? "")) problems.push("has a key that is no lower-case name");
	if (!groups.has(parameter.group)) problems.push(`is of the unknown group ${parameter.group}`);
	if (parameter.basic !== undefined && !(Number.isInteger(parameter.basic) && parameter.basic > 0))
		problems.push("has a place among the basics that is no whole number above 0");
	if (!["number", "integer", "choice", "colour"].includes(parameter.kind))
		problems.push(`is of the unknown kind ${parameter.kind}`);
	if (parameter.kind === "colour") {
		if (!/^[0-9a-f]{6}$/.test(parameter.default)) problems.push("has a default that is no colour");
		if (!parameter.look) problems.push("is a colour that the core would read");
		return problems;
	}
	if (parameter.kind === "choice") {
		const last = (parameter.options ?? []).length - 1;
		if (last < 1) problems.push("is a choice of fewer than two options");
		if (!(parameter.default in (parameter.options ?? []))) problems.push("has a default that is none of its options");
		return problems;
	}
	const { min, max, default: standard } = parameter;
	if (!(min < max)) problems.push("has an empty range");
	if (!(standard >= min && standard <= max)) problems.push("has a default out of its range");
	if (!(parameter.step > 0)) problems.push("has no step above 0");
	return problems;
}

/** Throws with every problem of `table`, which was read from `source`. */
export function checkTable(table, source) {
	const groups = new Set(table.groups.map((group) => group.key));
	const problems = table.parameters.flatMap((p) => problemsOf(p, groups).map((problem) => `${p.key} ${problem}`));
	const places = new Set();
	for (const { key, link, slot } of table.parameters) {
		for (const place of [`key ${key}`, `link ${link} ${slot ?? ""}`]) {
			if (places.has(place)) problems.push(`${key} repeats ${place.trim()}`);
			places.add(place);
		}
	}
	if (problems.length > 0) throw new Error(`${source}: ${problems.join("; ")}`);
}
