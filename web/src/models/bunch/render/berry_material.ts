import { ShaderMaterial, Vector2, Vector3 } from "three";
import { smoothstep } from "../../../plant/colour";
import type { Skin } from "../parts/skin";
import { BERRY_FRAGMENT, BERRY_VERTEX } from "./berry_shader";
import type { SharedUniforms } from "./lamp_shader";

/** Index of no berry. */
export const NONE = -1;

/** Creates the material shared by all berries. */
export function berryMaterial(shared: SharedUniforms): ShaderMaterial {
	return new ShaderMaterial({
		name: "berry",
		vertexShader: BERRY_VERTEX,
		fragmentShader: BERRY_FRAGMENT,
		uniforms: {
			...shared,
			vertexRecords: { value: null },
			patternVertices: { value: 0 },
			highlighted: { value: NONE },
			ripeAbsorption: { value: new Vector3() },
			unripeAbsorption: { value: new Vector3() },
			translucency: { value: new Vector2() },
			wax: { value: new Vector3() },
			grooves: { value: new Vector3() },
			grooveDepth: { value: new Vector2() },
			scar: { value: 1 },
			bloom: { value: 0 },
			lenticels: { value: 0 },
			uneven: { value: 0 },
			sunward: { value: new Vector3() },
			amber: { value: 0 },
			rind: { value: 0 },
			veins: { value: 0 },
			seedsSeen: { value: 0 },
		},
	});
}

/** Sets the uniforms that describe the skin of all berries. */
export function setSkin({ uniforms }: ShaderMaterial, skin: Skin): void {
	const { ripeFlesh, unripeFlesh, fruit } = skin;
	uniforms.ripeAbsorption.value.fromArray(ripeFlesh.absorption);
	uniforms.unripeAbsorption.value.fromArray(unripeFlesh.absorption);
	uniforms.translucency.value.set(ripeFlesh.translucency, unripeFlesh.translucency);
	uniforms.wax.value.fromArray(skin.wax);
	uniforms.sunward.value.fromArray(skin.sunned.towards);
	uniforms.amber.value = skin.sunned.amber;
	uniforms.grooves.value.fromArray(fruit.grooves);
	uniforms.grooveDepth.value.fromArray(fruit.depth);
	for (const key of ["bloom", "lenticels", "uneven"] as const) uniforms[key].value = skin[key];
	for (const key of ["rind", "veins", "scar"] as const) uniforms[key].value = fruit[key];
	// Seeds are visible through clear flesh only; otherwise the shader skips them.
	uniforms.seedsSeen.value = smoothstep(0.35, 0.85, Math.max(ripeFlesh.translucency, unripeFlesh.translucency));
}
