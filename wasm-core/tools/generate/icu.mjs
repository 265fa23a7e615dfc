/**
 * Reads messages in the syntax of ICU MessageFormat 1: text, `{name}`, `{count, plural, one {# berry} other {# berries}}`,
 * `{kind, select, leaf {…} other {…}}`. `#` in a plural is its number. Written here because code is generated before
 * packages are installed; tests/tools/icu.test.ts compares it with the reader of FormatJS.
 *
 * @typedef {string
 *   | { name: string }
 *   | { number: string }
 *   | { name: string, kind: "plural" | "select", cases: Record<string, Part[]> }} Part
 */

/**
 * @param {string} message
 * @returns {Part[]}
 * @throws Error with the column
 */
export function readMessage(message) {
	let at = 0;
	const fail = (problem) => {
		throw new Error(`column ${at + 1}: ${problem} in “${message}”`);
	};
	const take = (pattern, expected) => {
		pattern.lastIndex = at;
		const found = pattern.exec(message);
		if (!found) fail(`expected ${expected}`);
		at += found[0].length;
		return found[0];
	};
	const name = () => take(/\s*[a-z][a-z0-9_]*\s*/y, "a name in lower case").trim();

	/** Parts up to a closing brace or the end; `counted` is the argument that `#` stands for. */
	function parts(counted) {
		/** @type {Part[]} */
		const list = [];
		while (at < message.length && message[at] !== "}") {
			if (message[at] === "{") list.push(argument(counted));
			else if (message[at] === "#" && counted) {
				at++;
				list.push({ number: counted });
			} else list.push(take(counted ? /[^{}#]+/y : /[^{}]+/y, "text"));
		}
		return list;
	}

	/**
	 * Reads an argument from its opening brace, at the current position.
	 * @param counted name of the number that `#` stands for: that of the innermost plural
	 */
	function argument(counted) {
		at++;
		const key = name();
		if (message[at] === "}") {
			at++;
			return { name: key };
		}
		take(/,\s*/y, "a comma or a closing brace");
		const kind = take(/(plural|select|number)\s*/y, "plural, select or number").trim();
		if (kind === "number") {
			take(/\}/y, "a closing brace");
			return { number: key };
		}
		take(/,\s*/y, "a comma");
		const cases = {};
		while (message[at] !== "}") {
			const label = take(/\s*(=\d+|[a-z_]+)\s*/y, "a case").trim();
			take(/\{/y, "an opening brace");
			cases[label] = parts(kind === "plural" ? key : counted);
			take(/\}\s*/y, "a closing brace");
		}
		at++;
		if (!cases.other) fail(`${key} has no case “other”`);
		return { name: key, kind, cases };
	}

	const list = parts();
	if (at < message.length) fail("unexpected closing brace");
	return list;
}

/**
 * Names of the arguments in the order of their first use, with the kind of value that each must have.
 * @param {Part[]} parts
 * @returns {Map<string, "number" | "text">}
 */
export function argumentsOf(parts) {
	const found = new Map();
	const visit = (list) => {
		for (const part of list) {
			if (typeof part === "string") continue;
			const key = part.number ?? part.name;
			const isNumber = part.number !== undefined || part.kind === "plural";
			if (!found.has(key) || isNumber) found.set(key, isNumber ? "number" : "text");
			for (const each of Object.values(part.cases ?? {})) visit(each);
		}
	};
	visit(parts);
	return found;
}
