#ifndef PANICLE_TREE_INCLUDED
#define PANICLE_TREE_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"
#include "Wind.hlsl"

TEXTURE2D(_BaseMap);
SAMPLER(sampler_BaseMap);
TEXTURE2D(_BumpMap);
SAMPLER(sampler_BumpMap);

CBUFFER_START(UnityPerMaterial)
float4 _BaseMap_ST;
half4 _BaseColor;
half _Cutoff;
half _Smoothness;
half _Translucency;
float _TreeHeight;
float _Cull;
CBUFFER_END

struct Attributes
{
    float4 position : POSITION;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float4 data : COLOR;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 clip : SV_POSITION;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;
    float4 tangent : TEXCOORD2;
    float2 uv : TEXCOORD3;
    half occlusion : TEXCOORD4;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

Varyings TreeVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(input);
    UNITY_TRANSFER_INSTANCE_ID(input, output);
    float3 place = input.position.xyz + WindOffset(input.position.xyz, input.normal, input.data, _TreeHeight);
    output.world = TransformObjectToWorld(place);
    output.clip = TransformWorldToHClip(output.world);
    output.normal = TransformObjectToWorldNormal(input.normal);
    output.tangent = float4(TransformObjectToWorldDir(input.tangent.xyz), input.tangent.w * GetOddNegativeScale());
    output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
    output.occlusion = input.data.a;
    return output;
}

/// Leaves out pixels outside the leaves, and those of a level that fades.
half4 VisibleColour(Varyings input)
{
    half4 colour = _BaseColor * SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv);
    clip(colour.a - _Cutoff);
#ifdef LOD_FADE_CROSSFADE
    LODFadeCrossFade(input.clip);
#endif
    return colour;
}

half4 TreeFragment(Varyings input) : SV_Target
{
    UNITY_SETUP_INSTANCE_ID(input);
    half4 colour = VisibleColour(input);
    float3 bitangent = input.tangent.w * cross(input.normal, input.tangent.xyz);
    half3 bumped = UnpackNormal(SAMPLE_TEXTURE2D(_BumpMap, sampler_BumpMap, input.uv));
    bool hasTangent = dot(input.tangent.xyz, input.tangent.xyz) > 0.01;
    // The normals of leaf cards point out of the crown: both sides use them as they are.
    float3 normal = normalize(hasTangent ? mul(bumped, float3x3(input.tangent.xyz, bitangent, input.normal)) : input.normal);

    InputData lit = (InputData)0;
    lit.positionWS = input.world;
    lit.normalWS = normal;
    lit.viewDirectionWS = GetWorldSpaceNormalizeViewDir(input.world);
    lit.shadowCoord = TransformWorldToShadowCoord(input.world);
    lit.bakedGI = SampleSH(normal);
    lit.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.clip);
    SurfaceData surface = (SurfaceData)0;
    surface.albedo = colour.rgb;
    surface.smoothness = _Smoothness;
    surface.occlusion = input.occlusion;
    surface.alpha = 1;
    surface.normalTS = half3(0, 0, 1);
    half4 result = UniversalFragmentPBR(lit, surface);
    // Light from behind shines through leaves.
    Light sun = GetMainLight();
    result.rgb += _Translucency * input.occlusion * saturate(dot(-normal, sun.direction)) * sun.color * colour.rgb;
    return result;
}

half4 DepthFragment(Varyings input) : SV_Target
{
    UNITY_SETUP_INSTANCE_ID(input);
    VisibleColour(input);
    return 0;
}

float3 _LightDirection;

Varyings ShadowVertex(Attributes input)
{
    Varyings output = TreeVertex(input);
    output.clip = TransformWorldToHClip(ApplyShadowBias(output.world, output.normal, _LightDirection));
#if UNITY_REVERSED_Z
    output.clip.z = min(output.clip.z, UNITY_NEAR_CLIP_VALUE);
#else
    output.clip.z = max(output.clip.z, UNITY_NEAR_CLIP_VALUE);
#endif
    return output;
}

#endif
