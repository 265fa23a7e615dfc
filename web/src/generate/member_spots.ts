/** Positions of a member's organs with the requested tags, where other members may hang. */

import type { Member, MemberRequest } from "../models/member";
import type { Plant } from "../plant/plant";

/** Returns the positions of the organs with the requested tags, by tag; nothing where no tags are requested. */
export function spotsOf(plant: Plant, { spots }: MemberRequest): Pick<Member, "spots"> {
	return spots ? { spots: Object.fromEntries(spots.map((tag) => [tag, placesOf(plant, tag)])) } : {};
}

/** Returns the positions (x y z each) of the organs with a tag. */
function placesOf({ organs: { tag, tags, count, transforms } }: Plant, wanted: string): Float32Array {
	const width = transforms.length / Math.max(1, count);
	const places: number[] = [];
	for (let i = 0; i < count; i++)
		if (tags[tag[i]] === wanted) places.push(...transforms.subarray(width * i, width * i + 3));
	return Float32Array.from(places);
}
