// Dust in the air: it takes light away and sends some of it back.
#pragma once

namespace adit::sim {

/// A homogeneous cloud of single scattering, and single grains near the lens.
struct DustConfig {
  float extinction_1_m = 0.0f;     ///< sigma_t
  float scattering_albedo = 0.8f;  ///< share of the extinction that is scattering
  float asymmetry = 0.7f;          ///< Henyey-Greenstein g, towards forward scattering
  float grains_per_m3 = 0.0f;      ///< grains big enough to be seen one by one near the lens
  float grain_diameter_mm = 0.15f;
  float grain_drift_m_s = 0.15f;  ///< speed of the air that carries them
};

/// Henyey-Greenstein phase function, 1/sr; its integral over the sphere is 1.
/// @param cosine of the angle by which light is turned: 1 goes straight on. @param g (-1, 1).
[[nodiscard]] float henyey_greenstein(float cosine, float g) noexcept;

}  // namespace adit::sim
