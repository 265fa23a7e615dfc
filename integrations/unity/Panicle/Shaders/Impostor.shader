Shader "Panicle/Impostor"
{
    Properties
    {
        _BaseMap("Colour", 2D) = "white" {}
        _SurfaceMap("Normals and depth", 2D) = "gray" {}
        _Centre("Centre (m)", Vector) = (0, 5, 0, 0)
        _Radius("Radius (m)", Float) = 5
        _Frames("Pictures along an edge", Float) = 8
    }
    SubShader
    {
        Tags { "RenderType" = "TransparentCutout" "Queue" = "AlphaTest" "RenderPipeline" = "UniversalPipeline" "DisableBatching" = "True" }
        Cull Off

        Pass
        {
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForward" }
            HLSLPROGRAM
            #pragma vertex ImpostorVertex
            #pragma fragment ImpostorFragment
            #pragma multi_compile_instancing
            #pragma multi_compile _ LOD_FADE_CROSSFADE
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"

            TEXTURE2D(_BaseMap);
            SAMPLER(sampler_BaseMap);
            TEXTURE2D(_SurfaceMap);
            SAMPLER(sampler_SurfaceMap);

            CBUFFER_START(UnityPerMaterial)
            float4 _Centre;
            float _Radius;
            float _Frames;
            CBUFFER_END

            struct Attributes
            {
                float4 position : POSITION;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct Varyings
            {
                float4 clip : SV_POSITION;
                float3 place : TEXCOORD0;
                float3 eye : TEXCOORD1;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            /// Returns a horizontal direction across a direction of view.
            float3 Sideways(float3 towards)
            {
                return abs(towards.y) > 0.9999 ? float3(1, 0, 0) : normalize(cross(float3(0, 1, 0), towards));
            }

            Varyings ImpostorVertex(Attributes input)
            {
                Varyings output = (Varyings)0;
                UNITY_SETUP_INSTANCE_ID(input);
                UNITY_TRANSFER_INSTANCE_ID(input, output);
                output.eye = TransformWorldToObject(GetCameraPositionWS());
                float3 towards = normalize(output.eye - _Centre.xyz);
                float3 sideways = Sideways(towards);
                float3 up = cross(towards, sideways);
                output.place = _Centre.xyz + _Radius * (input.position.x * sideways + input.position.y * up);
                output.clip = TransformObjectToHClip(output.place);
                return output;
            }

            /// Mirrors a vector between Unity's coordinates and those of glTF, in which the pictures were drawn.
            float3 Mirrored(float3 vector_)
            {
                return float3(-vector_.x, vector_.y, vector_.z);
            }

            /// Returns the place of a direction in the grid, 0 … 1.
            float2 GridPlace(float3 direction)
            {
                float3 d = float3(direction.x, max(direction.y, 0), direction.z);
                d /= abs(d.x) + abs(d.y) + abs(d.z);
                return 0.5 + 0.5 * float2(d.x + d.z, d.x - d.z);
            }

            float3 GridDirection(float2 place)
            {
                float2 p = 2 * place - 1;
                float3 d = float3(0.5 * (p.x + p.y), 0, 0.5 * (p.x - p.y));
                d.y = 1 - abs(d.x) - abs(d.z);
                return normalize(d);
            }

            /// Returns the place in the atlas where a ray from the eye meets the plane of a picture.
            float2 FramePlace(float2 frame, float3 centre, float3 eye, float3 ray)
            {
                float3 towards = GridDirection(frame / (_Frames - 1));
                float3 sideways = Sideways(towards);
                float3 met = eye + ray * (dot(centre - eye, towards) / dot(ray, towards)) - centre;
                float2 inside = 0.5 + 0.5 * float2(dot(met, sideways), dot(met, cross(towards, sideways))) / _Radius;
                inside = clamp(inside, 0.002, 0.998);
                // The first row of pictures is the upper one.
                return float2(frame.x + inside.x, _Frames - 1 - frame.y + inside.y) / _Frames;
            }

            /// Returns the normal in a picture, from its coordinates in the view of the picture.
            float3 FrameNormal(float2 frame, float2 at)
            {
                float3 towards = GridDirection(frame / (_Frames - 1));
                float3 sideways = Sideways(towards);
                float2 n = 2 * SAMPLE_TEXTURE2D_LOD(_SurfaceMap, sampler_SurfaceMap, at, 0).xy - 1;
                return n.x * sideways + n.y * cross(towards, sideways) + sqrt(max(0, 1 - dot(n, n))) * towards;
            }

            half4 ImpostorFragment(Varyings input) : SV_Target
            {
                UNITY_SETUP_INSTANCE_ID(input);
                float3 eye = Mirrored(input.eye), centre = Mirrored(_Centre.xyz);
                float3 ray = normalize(Mirrored(input.place) - eye);
                float2 grid = GridPlace(normalize(eye - centre)) * (_Frames - 1);
                float2 first = min(floor(grid), _Frames - 2);
                float2 rest = grid - first;
                float2 second = first + (rest.x > rest.y ? float2(1, 0) : float2(0, 1));
                float2 nearest[3] = { first, second, first + 1 };
                float most = max(rest.x, rest.y), least = min(rest.x, rest.y);
                float shares[3] = { 1 - most, most - least, least };
                half4 colour = 0;
                float3 normal = 0;
                for (int i = 0; i < 3; i++)
                {
                    float2 at = FramePlace(nearest[i], centre, eye, ray);
                    half4 picture = SAMPLE_TEXTURE2D_LOD(_BaseMap, sampler_BaseMap, at, 0);
                    colour += shares[i] * half4(picture.a * picture.rgb, picture.a);
                    normal += shares[i] * FrameNormal(nearest[i], at);
                }
                // Of pixels that are partly covered, a share is drawn: distant crowns stay as open as they are.
                float grain = frac(52.9829189 * frac(dot(input.clip.xy, float2(0.06711056, 0.00583715))));
                clip(colour.a - lerp(0.15, 0.75, grain));
#ifdef LOD_FADE_CROSSFADE
                LODFadeCrossFade(input.clip);
#endif
                normal = TransformObjectToWorldNormal(normalize(Mirrored(normal)));
                half3 albedo = colour.rgb / colour.a;
                Light sun = GetMainLight();
                return half4(albedo * (saturate(dot(normal, sun.direction)) * sun.color + SampleSH(normal)), 1);
            }
            ENDHLSL
        }
    }
}
