import { float } from "../../../render/glsl";
import { TURNING } from "../parts/skin_rules";

/**
 * Shader functions for ripening and for light inside a berry. In berry space the berry is the unit ball about the
 * origin, so that paths have formulae; lengths are in its radii. `axis` points to the tip, `form` is the berry's
 * record: half width, half length, shrivel, seeds.
 */
export const FLESH_CHUNK = /* glsl */ `
uniform vec3 ripeAbsorption;
uniform vec3 unripeAbsorption;
uniform vec2 translucency;
uniform float uneven;

vec3 in_ball(vec3 place, vec3 axis, vec4 form) {
	return (place + axis * (dot(place, axis) * (form.x / form.y - 1.0))) / form.x;
}
vec3 towards_in_ball(vec3 d, vec3 axis, vec4 form) {
	return normalize(d + axis * (dot(d, axis) * (form.x / form.y - 1.0)));
}

// How far the colour has turned at a point: it starts at the tip and in patches, and crosses the berry unevenly.
float turned_at(float turned, float along, float coarse, float fine) {
	float width = ${float(TURNING.width)} + ${float(TURNING.uneven)} * uneven;
	float late = 0.5 - ${float(TURNING.along)} * along + ${float(TURNING.coarse)} * uneven * (coarse - 0.5) + ${float(TURNING.fine)} * uneven * (fine - 0.5);
	return smoothstep(0.0, 1.0, (turned * (1.0 + width) - clamp(late, 0.0, 1.0)) / width);
}

// How visible the flesh is through the skin.
float clearness(float turned, vec4 form) {
	return mix(translucency.y, translucency.x, turned) * (1.0 - 0.6 * form.z);
}

// Length of the path from a point in the ball to its surface.
float way_out(vec3 at, vec3 towards) {
	float b = dot(at, towards);
	return sqrt(max(0.0, b * b + 1.0 - dot(at, at))) - b;
}

// The line of sight within the ball: where it enters, its unit direction, its length.
struct Path { vec3 from; vec3 inward; float run; };
Path path_inside(vec3 at, vec3 bent, vec3 axis, vec4 form) {
	vec3 from = at * min(1.0, 0.998 / length(at));
	vec3 inward = towards_in_ball(bent, axis, form);
	return Path(from, inward, way_out(from, inward));
}

// Light of both lights scattered once on the line of sight: at each of three points, the light left on its way in and
// the scattered light left on its way out.
vec3 scattered(Path path, vec3 absorption, vec3 keyward, vec3 keyLight, vec3 rimward, vec3 rimLight) {
	vec3 sum = vec3(0.0);
	for (int i = 0; i < 3; i++) {
		float gone = path.run * (0.12 + 0.36 * float(i));
		vec3 p = path.from + gone * path.inward;
		sum += keyLight * exp(-absorption * (gone + way_out(p, keyward)));
		sum += rimLight * exp(-absorption * (gone + way_out(p, rimward)));
	}
	return sum * (0.34 * path.run);
}

// Share of the light on the line of sight that the seeds absorb. They are placed round the axis, pointing to the seat;
// the flesh blurs them by their depth.
float seed_shade(Path path, vec3 axis, vec4 form, float phase) {
	vec3 east = normalize(cross(axis, vec3(0.31, 0.17, 0.93)));
	vec3 north = cross(axis, east);
	float shade = 0.0;
	int count = int(form.w + 0.5);
	for (int k = 0; k < count; k++) {
		float turn = 6.2831853 * (phase + float(k) / form.w);
		vec3 centre = 0.27 * (cos(turn) * east + sin(turn) * north) - (0.12 + 0.08 * sin(9.0 * turn)) * axis;
		vec3 from = path.from - centre;
		// In the space where the seed is a unit ball; it tapers to a point towards the seat.
		float taper = 0.16 * (1.0 + 0.35 * dot(from, axis));
		vec3 stretch = axis * (taper / (0.36 * form.x / form.y) - 1.0);
		vec3 a = (from + stretch * dot(from, axis)) / taper;
		vec3 b = (path.inward + stretch * dot(path.inward, axis)) / taper;
		float nearest = max(0.0, -dot(a, b) / dot(b, b));
		float soft = 0.35 + 0.5 * nearest;
		shade = max(shade, (1.0 - smoothstep(1.0 - soft, 1.0 + soft, length(a + nearest * b))) * exp(-0.7 * nearest));
	}
	return shade;
}
`;
