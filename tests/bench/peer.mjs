/** The peer: `lindenmayer` from npm rewrites the same rule as many steps. */
import LSystem from "lindenmayer";

/** Sum of the lengths of its strings over all steps. */
export function peerModules(steps) {
	const system = new LSystem({
		axiom: [{ symbol: "A", params: [1] }],
		productions: {
			A: ({ part }) => {
				const s = part.params[0] / 1.456;
				return [
					{ symbol: "F", params: [part.params[0]] },
					{ symbol: "[" },
					{ symbol: "+" },
					{ symbol: "A", params: [s] },
					{ symbol: "]" },
					{ symbol: "[" },
					{ symbol: "-" },
					{ symbol: "A", params: [s] },
					{ symbol: "]" },
				];
			},
		},
	});
	let modules = 0;
	for (let step = 0; step < steps; step++) {
		system.iterate(1);
		modules += system.getRaw().length;
	}
	return modules;
}
