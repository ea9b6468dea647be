#pragma once
// The strain energies of thin elastic sheets (ElasticSheet.h), an area of the reference shape.

namespace vesicle
{

enum class ElasticLaw
{
  neo_hookean, ///< W = (G/2) (I1 − 1 + 1/(I2 + 1))
  skalak       ///< W = (G/4) (I1² + 2 I1 − 2 I2 + C I2²)
};

}
