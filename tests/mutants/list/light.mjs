/** Effects that only a drawn picture shows: light, shadow, wax. */
const LIGHT = "tests/e2e/light.spec.ts";
const CONTEXTS = "tests/e2e/contexts.spec.ts";
const FIGURE = "web/src/models/bunch/render";

export default [
	{
		file: `${FIGURE}/lamp_shader.ts`,
		suites: [`${LIGHT}: berries stand in each other's light`],
		faults: [
			{
				id: "lamp-no-key-shadows",
				find: "share *= 1.0 - most *",
				replace: "share *= 1.0 - 0.0 * most *",
				breaks: "no berry stands in another's light",
			},
			{
				id: "lamp-shadows-of-hidden-berries",
				find: "berriesShown < 0.5 ? vec2(1.0) :",
				replace: "berriesShown < -0.5 ? vec2(1.0) :",
				suites: [`${LIGHT}: stems that stand bare are brighter`],
				breaks: "bare stems stand in the shadow of berries that are not shown",
			},
		],
	},
	{
		file: `${FIGURE}/berry_shader.ts`,
		suites: [`${LIGHT}: wax pales dark skins`],
		faults: [
			{
				id: "shader-no-wax",
				find: "waxed = (1.0 - exp(",
				replace: "waxed = 0.0 * (1.0 - exp(",
				breaks: "no berry of the view has bloom",
			},
			{
				id: "shader-unlit-skins",
				find: "float nk = dot(n, keyDirection);",
				replace: "float nk = dot(n, -keyDirection);",
				suites: [`${LIGHT}: the key light comes from the upper left`],
				breaks: "berries are lit from the side away from the lamp",
			},
			{
				id: "shader-nothing-marked",
				find: "nature.x == highlighted ? 1.0 : 0.0",
				replace: "nature.x == highlighted ? 0.0 : 0.0",
				suites: [`${LIGHT}: a turn to the right takes the berry in front to the right`],
				breaks: "the berry pointed at is not marked",
			},
		],
	},
	{
		file: "web/src/render/light_shader.ts",
		suites: [`${LIGHT}: the key light comes from the upper left`],
		faults: [
			{
				id: "lamps-stay-behind-the-viewer",
				find: "uniforms.keyDirection.value.copy(rig.key.direction).transformDirection(cameraWorld);",
				replace: "uniforms.keyDirection.value.set(0, 0, 1);",
				breaks: "the light is walked around in place of the plant turned in it",
			},
		],
	},
	{
		file: "web/src/render/capsule_shadow.ts",
		suites: [`${LIGHT}: the bunch's shadow lies on the paper`],
		faults: [
			{
				id: "paper-shadow-towards-the-lamp",
				find: "return from.xy - lamp.xy * way;",
				replace: "return from.xy + lamp.xy * way;",
				breaks: "the shadow falls towards the light",
			},
			{
				id: "paper-without-shadow",
				find: "gl_FragColor = vec4(0.0, 0.0, 0.0, most * soft);",
				replace: "gl_FragColor = vec4(0.0, 0.0, 0.0, 0.0);",
				breaks: "the bunch throws no shadow on the paper",
			},
		],
	},
	{
		file: "web/src/render/backdrop.ts",
		suites: [`${LIGHT}: the bunch's shadow lies on the paper`],
		faults: [
			{
				id: "backdrop-shadow-of-no-depth",
				find: "uniforms.shadow.value = rig.shadow.depth;",
				replace: "uniforms.shadow.value = 0;",
				breaks: "the paper shows no shadow",
			},
		],
	},
	{
		file: "web/src/render/renderer.ts",
		suites: [`${CONTEXTS}: twenty views made and disposed`],
		faults: [
			{
				id: "renderer-keeps-its-context",
				find: "this.#three.forceContextLoss();",
				replace: "",
				breaks: "after twenty views browsers drop the first one's picture",
			},
			{
				id: "renderer-copies-another-size",
				find: "onto.drawImage(this.canvas, 0, this.canvas.height - height, width, height, 0, 0, width, height);",
				replace: "onto.drawImage(this.canvas, 0, 0, width, height, 0, 0, width, height);",
				suites: [`${CONTEXTS}: twenty views share one context`],
				breaks: "views that share a renderer show the wrong part of its canvas",
			},
			{
				id: "renderer-too-dark",
				find: "this.#three.toneMapping = NeutralToneMapping;",
				replace: "this.#three.toneMapping = NeutralToneMapping;\n\t\tthis.#three.toneMappingExposure = 0.7;",
				suites: [`${LIGHT}: a matt card is as bright`],
				breaks: "everything is a third too dark",
			},
		],
	},
];
