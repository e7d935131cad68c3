<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> -4.249711755 2.821356057 -3.528462838 3.542604974 </Joint>
<Joint type="1"> 9.892423869 -11.32077957 10.61367279 -10.59953065 </Joint>
<Joint type="1"> -4.249711755 2.835498193 9.906566004 -11.32077957 </Joint>
<Joint type="1"> -3.542604974 3.542604974 10.61367279 -10.61367279 </Joint>
<Joint type="1"> -0.007071067812 -0.007071067812 0.714177849 0.714177849 </Joint>
<Joint type="1"> 0.7000357134 -0.714177849 1.42128463 0.007071067812 </Joint>
<Joint type="1"> -0.007071067812 0.007071067812 0.714177849 -0.714177849 </Joint>
<Joint type="1"> 0.7000357134 0.714177849 1.42128463 -0.007071067812 </Joint>
</Jointlist>
<Fixedpointlist>
<Point> -3.181980515 2.474873734 </Point>
<Point> 9.545941546 -10.25304833 </Point>
</Fixedpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>
