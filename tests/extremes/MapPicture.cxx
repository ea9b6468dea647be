#include "MapPicture.h"

#include "render/Picture.h"
#include "render/PngFile.h"
#include "render/RenderBackend.h"
#include "render/TextStyle.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkContextActor.h"
#include "vtkContextItem.h"
#include "vtkContextScene.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <map>

namespace vesicle::test
{
namespace
{

constexpr int width = 1280, row_height = 54, margin = 16, names_width = 250, gap = 4, head = 84;

std::array<unsigned char, 3> color_of(const std::string& end)
{
  static const std::map<std::string, std::array<unsigned char, 3>> colors{
    { "runs", { 190, 215, 240 } }, { "refused", { 225, 225, 225 } },
    { "stopped", { 250, 215, 150 } }, { "crawls", { 230, 120, 90 } }, { "wrong", { 200, 60, 60 } }
  };
  return colors.at(end);
}

std::vector<std::vector<MapBox>> rows_of(const std::vector<MapBox>& boxes)
{
  std::vector<std::vector<MapBox>> rows;
  for (const MapBox& box : boxes)
  {
    if (rows.empty() || rows.back().front().row != box.row)
      rows.emplace_back();
    rows.back().push_back(box);
  }
  return rows;
}

class MapItem : public vtkContextItem
{
public:
  static MapItem* New();
  vtkTypeMacro(MapItem, vtkContextItem);

  std::string Title;
  std::vector<std::vector<MapBox>> Rows;
  int Height = 0;

  bool Paint(vtkContext2D* painter) override
  {
    set_text_style(painter->GetTextProp(), 24);
    this->Text(painter, margin, this->Height - 34., this->Title);
    this->Legend(painter);
    for (std::size_t r = 0; r < this->Rows.size(); ++r)
      this->Row(
        painter, this->Height - head - static_cast<double>(r + 1) * row_height, this->Rows[r]);
    return true;
  }

private:
  void Text(vtkContext2D* painter, double x, double y, const std::string& text)
  {
    painter->DrawString(static_cast<float>(x), static_cast<float>(y), text.c_str());
  }

  void Box(vtkContext2D* painter, double x, double y, double w, double h, const std::string& end)
  {
    auto color = color_of(end);
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    painter->GetBrush()->SetColor(color.data());
    painter->DrawRect(
      static_cast<float>(x), static_cast<float>(y), static_cast<float>(w), static_cast<float>(h));
  }

  void Legend(vtkContext2D* painter)
  {
    set_text_style(painter->GetTextProp(), 17);
    double x = margin;
    for (const char* end : { "runs", "refused", "stopped", "crawls", "wrong" })
    {
      this->Box(painter, x, this->Height - 72., 18, 18, end);
      this->Text(painter, x + 24, this->Height - 70., end);
      x += 120;
    }
  }

  void Row(vtkContext2D* painter, double y, const std::vector<MapBox>& boxes)
  {
    set_text_style(painter->GetTextProp(), 19);
    this->Text(painter, margin, y + row_height / 2. - 8, boxes.front().row);
    const double each =
      static_cast<double>(width - names_width - margin) / std::max<double>(8, boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      const double x = names_width + i * each;
      this->Box(painter, x, y + gap, each - gap, row_height - gap, boxes[i].end);
      set_text_style(painter->GetTextProp(), 15);
      this->Text(painter, x + 6, y + row_height / 2. + 4, boxes[i].label);
      set_text_style(painter->GetTextProp(), 13);
      this->Text(painter, x + 6, y + 12, boxes[i].note);
    }
  }
};

vtkStandardNewMacro(MapItem);

}

void write_map(
  const std::filesystem::path& file, const std::string& title, const std::vector<MapBox>& boxes)
{
  render_backend();
  vtkNew<MapItem> item;
  item->Title = title;
  item->Rows = rows_of(boxes);
  item->Height = head + static_cast<int>(item->Rows.size()) * row_height + margin;
  const auto window = off_screen_window({ width, item->Height }, 0);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  vtkNew<vtkContextActor> canvas;
  canvas->GetScene()->AddItem(item);
  canvas->GetScene()->SetRenderer(renderer);
  renderer->AddActor(canvas);
  window->AddRenderer(renderer);
  window->Render();
  write_png(file, grab_image(window));
}

}
