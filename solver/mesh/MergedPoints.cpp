#include "solver/mesh/MergedPoints.h"

#include "solver/mesh/PointHash.h"

namespace vesicle
{

MergedPoints merged_points(const Points& points, double distance)
{
  MergedPoints merged;
  PointHash seen(distance);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Vector3 x = (points.row(i) - points.row(0)).transpose(); // far from the origin, too
    const int next = static_cast<int>(merged.kept.size());
    const int twin = seen.find(x);
    merged.number.push_back(twin >= 0 ? twin : next);
    if (twin < 0)
    {
      seen.insert(x, next);
      merged.kept.push_back(static_cast<int>(i));
    }
  }
  return merged;
}

Points kept_points(const Points& points, const MergedPoints& merged)
{
  return points(merged.kept, Eigen::all);
}

}
