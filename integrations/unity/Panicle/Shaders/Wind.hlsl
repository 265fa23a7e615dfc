#ifndef PANICLE_WIND_INCLUDED
#define PANICLE_WIND_INCLUDED

// Wind from vertex data: the colour is branch phase (r), branch weight (g), leaf phase (b) and occlusion (a).
// Set these for all trees by Shader.SetGlobalFloat and SetGlobalVector; 0 is calm, 1 a fresh breeze.
float _PanicleWindStrength;
float4 _PanicleWindDirection;

/// Returns the offset of a vertex in the coordinates of the tree, metres.
float3 WindOffset(float3 place, float3 normal, float4 data, float height)
{
    float4x4 tree = GetObjectToWorldMatrix();
    float3 wanted = dot(_PanicleWindDirection, _PanicleWindDirection) > 0 ? _PanicleWindDirection.xyz : float3(0.8, 0, 0.6);
    float3 along = normalize(mul((float3x3)GetWorldToObjectMatrix(), wanted));
    float3 across = float3(-along.z, 0, along.x);
    // Neighbouring trees sway at different times.
    float late = dot(float3(tree._m03, tree._m13, tree._m23), float3(0.37, 0, 0.53));
    float h = saturate(place.y / height);
    float turn = 6.2831853 * data.r + late;
    float trunk = 0.022 * height * h * h * (0.6 + 0.4 * sin(1.3 * _Time.y + late));
    float branch = 0.02 * height * data.g * sin(2.1 * _Time.y + turn);
    float leaf = 0.03 * step(0.001, data.b) * data.g * sin(7.0 * _Time.y + 6.2831853 * data.b + turn);
    float3 sway = trunk * along + branch * (0.7 * along + 0.5 * across + float3(0, 0.4, 0));
    return _PanicleWindStrength * (sway + leaf * normal);
}

#endif
