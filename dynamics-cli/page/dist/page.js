/*! This script holds the following works.

three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var c_=Object.defineProperty;var h_=(n,t,e)=>t in n?c_(n,t,{enumerable:!0,configurable:!0,writable:!0,value:e}):n[t]=e;var Cf=(n,t,e)=>h_(n,typeof t!="symbol"?t+"":t,e);function H(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.startsWith("on")?i.addEventListener(s.slice(2),r):s==="class"?i.className=r:s.includes("-")||!(s in i)?i.setAttribute(s,r):i[s]=r;return i.append(...e.flat(1/0).filter(s=>s!=null)),i}function ai(n,t){let e=H("i",{},n);return t===null?[e]:[e,H("sub",{},String(t))]}function Rf(n){return H("data",{"data-key":n})}function Pf(n,t,e){n.value=String(t),n.title=String(t),n.textContent=e}var Xh=180/Math.PI;function Ho(n){if(Number.isNaN(n))return"\u2013";if(!Number.isFinite(n))return String(n);let t=Math.abs(n);if(t<5e-13)return"0";if(t<.001||t>=1e6)return n.toExponential(2);let e=t<10?4:t<100?3:t<1e3?2:1;return n.toFixed(e)}function Se(n,t=4){return String(Number(n.toPrecision(t)))}function u_(n){for(let t of[1,2,3,4,6,12]){let e=n/Math.PI*t,i=Math.round(e);if(i===0||Math.abs(e-i)>1e-9)continue;let s=i<0?"-":"",r=Math.abs(i)===1?"":String(Math.abs(i));return`${s}${r}\u03C0${t===1?"":`/${t}`}`}return null}function qh(n){let t=n?"\xB0":"rad";return{inDegrees:n,angleUnit:t,factor:i=>i==="revolute"&&n?Xh:1,position:i=>i==="revolute"?t:"m",velocity:i=>i==="revolute"?`${t}/s`:"m/s",acceleration:i=>i==="revolute"?`${t}/s\xB2`:"m/s\xB2",force:i=>i==="revolute"?"N m":"N",angle:i=>n?`${Se(i*Xh)}\xB0`:`${Se(i)} rad`,length:i=>`${Se(i)} m`,number:i=>Math.abs(i)<1e-12?"0":Se(i),cell:i=>n?Se(i*Xh,6):u_(i)??Se(i,6)}}var d_={motion:"Motion",free:"Free motion",pose:"Pose"},f_={motion:"From start to end, from rest to rest; inverse dynamics gives the torques.",free:"From the start under given torques; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes."};function Lf({label:n,key:t,min:e,max:i,get:s,set:r,factor:o,unit:a,about:l}){let c=H("input",{type:"range",step:"any","data-key":t,"aria-label":l}),u=H("input",{type:"number",step:"any","aria-label":`${l}, as a number`}),d=H("span",{class:"unit"}),h=H("p",{class:"refused",role:"alert"}),p=H("div",{class:"slider"},H("span",{class:"what"},n),c,u,d,h),_=()=>{let[g,m]=[s(),o()],[y,C]=[Math.min(e(),g),Math.max(i(),g)];Object.assign(c,{min:y*m,max:C*m}),c.value=g*m,c.setAttribute("aria-valuetext",`${Se(g*m)} ${a()}`),(document.activeElement!==u||h.textContent)&&(u.value=Se(g*m,5)),d.textContent=a()},x=g=>{let m=Number(g)/o(),y=g.trim()!==""&&Number.isFinite(m),C=y?r(m):"expected a number";h.textContent=C?`${y?`${g} is refused: `:""}${C}`:"",_()};return c.addEventListener("input",()=>x(c.value)),u.addEventListener("change",()=>x(u.value)),_(),{row:p,show:_}}function p_(n,t){let{state:e}=n,i=n.joints[t],[s,r]=n.ranges[t],o={min:()=>s,max:()=>r,factor:()=>n.units.factor(i.type),unit:()=>n.units.position(i.type)},a=(x,g=n.changed)=>({get:()=>e[x][t],set(m){e[x][t]=m,g()}}),l=i.type==="revolute"?Math.PI:n.size,c=x=>({min:()=>-x,max:()=>x}),u={...c(2*l),factor:o.factor,unit:()=>n.units.velocity(i.type)},d={...o,...a("q"),label:e.mode==="motion"?"start":ai("q",null),key:`q-${t}`,about:`${i.name}, position${e.mode==="pose"?"":" at the start"}`},h={...u,...a("qd"),label:ai("q\u0307",null),key:`qd-${t}`,about:`${i.name}, velocity${e.mode==="pose"?"":" at the start"}`};if(e.mode==="motion"){let x={...o,...a("end"),label:"end",key:`end-${t}`,about:`${i.name}, position at the end`};return[d,x]}if(e.mode==="pose"){let x={...c(4*l),...a("qdd"),factor:o.factor,unit:()=>n.units.acceleration(i.type),label:ai("q\u0308",null),key:`qdd-${t}`,about:`${i.name}, acceleration`};return[d,h,x]}if(e.law!=="constant")return[d,h];let p=Math.max(1,...n.table.rows.map(x=>x.mass))*9.81*n.size,_={...c(i.type==="revolute"?p:p/n.size),...a("torque"),factor:()=>1,unit:()=>n.units.force(i.type),label:ai("\u03C4",null),key:`tau-${t}`,about:`${i.name}, ${i.type==="revolute"?"torque":"force"}`};return[d,h,_]}function m_(n,{name:t,value:e,unit:i}){let s=i==="rad",[r,o]=s?[-Math.PI,Math.PI]:e<0?[3*e,0]:[0,3*e||1];return Lf({label:H("i",{},t),key:`field-${t}`,about:i?`field ${t}`:`field ${t}, without unit`,min:()=>r,max:()=>o,get:()=>n.fields[t],set:a=>n.setFields({[t]:a}),factor:()=>s?n.units.factor("revolute"):1,unit:()=>s?n.units.angleUnit:i})}function If({about:n,key:t,options:e,get:i,set:s}){let r=Object.entries(e).map(([a,l])=>H("option",{value:a},l)),o=H("select",{"data-key":t,onchange:()=>s(o.value)},r);return o.value=i(),H("label",{class:"choice"},H("span",{},n),o)}function g_({rows:n},t){let{on:e}=n[t];return n.filter(s=>!s.isPlace&&s.on===e).length>1||(e??-1)!==t-1?`on ${e===null?"the base":n[e].name}`:null}function Df(n){let{state:t,joints:e,first:i}=n,s=[],r=Object.entries(d_).map(([f,S])=>H("button",{type:"button",role:"tab","data-key":`mode-${f}`,onclick:()=>n.setMode(f)},S)),o=H("div",{class:"tabs",role:"tablist","aria-label":"Kind of motion"},r);o.addEventListener("keydown",({key:f})=>{let S={ArrowRight:1,ArrowLeft:-1}[f];if(!S)return;let I=r.findIndex(P=>P.getAttribute("aria-selected")==="true"),R=r[(I+S+r.length)%r.length];R.focus(),R.click()});let a=H("p",{class:"said"}),l=H("div",{class:"settings"}),c=H("div",{class:"joints"}),u=H("div",{role:"tabpanel"},a,l,c),d=H("input",{type:"number",min:"0.1",max:"60",step:"any","data-key":"duration"}),h=H("p",{class:"refused",role:"alert"});d.addEventListener("change",()=>{let f=Number(d.value);h.textContent=f>0?"":"expected a number above zero",f>0&&(t.duration=Math.min(f,60)),d.value=t.duration,n.changed()});let p={cycloidal:"cycloidal",quintic:"quintic polynomial",cubic:"cubic polynomial"},_={none:"none: free fall",constant:"constant",gravity:"G + K: the arm floats"},x=n.table.rows.some(f=>f.viscous!==0||f.coulomb.some(S=>S!==0)||f.stribeck);function g(){r.forEach(S=>{let I=S.dataset.key===`mode-${t.mode}`;S.setAttribute("aria-selected",I),S.tabIndex=I?0:-1}),a.textContent=f_[t.mode],d.value=t.duration;let f=[];if(t.mode!=="pose"&&f.push(H("label",{class:"choice"},H("span",{},"duration, s"),d),h),t.mode==="motion"){let S=I=>{t.profile=I,n.changed()};f.push(If({about:"profile",key:"profile",options:p,get:()=>t.profile,set:S}))}if(t.mode==="free"){let S=I=>{t.law=I,g(),n.changed()};if(f.push(If({about:"torques",key:"law",options:_,get:()=>t.law,set:S})),x){let I=H("input",{type:"checkbox",checked:t.hasFriction,"data-key":"friction"});I.addEventListener("change",()=>{t.hasFriction=I.checked,n.changed()}),f.push(H("label",{class:"check"},I,"friction"))}}l.replaceChildren(...f),s.length=0,c.replaceChildren(...e.flatMap((S,I)=>{let R=p_(n,I).map(Lf);s.push(...R);let P=n.table.rows.findIndex(it=>it.joint===I),U=H("button",{type:"button",class:"name",onclick:()=>n.select(P)});U.append(H("span",{class:"dot"}),H("b",{},String(I+1)),` ${S.name}`);let B=H("span",{class:"kind"},S.type),D=H("span",{class:"kind limits"}),k=H("div",{class:"head"},U,B,D),q=H("div",{class:"joint","data-joint":I},k,R.map(it=>it.row));q.addEventListener("focusin",()=>n.select(P));let O=g_(n.table,P);return O===null?q:[H("h3",{class:"branch"},O),q]})),y(),m()}function m(){let{factor:f,position:S}=n.units;c.querySelectorAll(".limits").forEach((I,R)=>{let{limits:P,type:U}=e[R],B=P?.map(D=>Se(D*f(U),4));I.textContent=B?`${B[0]} to ${B[1]} ${S(U)}`:"no limits"})}function y(){c.querySelectorAll(".joint").forEach((f,S)=>{let{selected:I}=t;f.classList.toggle("selected",n.table.rows[I]?.joint===S),f.style.setProperty("--color",`var(--joint-${S%8})`)})}let C=i.fields.map(f=>m_(n,f)),b=H("div",{class:"fields"},H("h3",{},"Parameters"),C.map(f=>f.row));n.on("mode",g),n.on("units",()=>{[...s,...C].forEach(f=>f.show()),m()}),n.on("selection",y),g();let A=H("button",{type:"button",class:"quiet",onclick(){let f=P=>t[P].fill(0);["qd","qdd","torque"].forEach(f);let{from:S,to:I,duration:R}=i;M.q.forEach((P,U)=>t.q[U]=S?.[U]??P),M.end.forEach((P,U)=>t.end[U]=I?.[U]??P),t.duration=R,n.setFields(Object.fromEntries(i.fields.map(({name:P,value:U})=>[P,U]))),g(),C.forEach(P=>P.show()),n.changed()}});A.append("Reset");let M={q:[...t.q],end:[...t.end]};return H("section",{class:"panel controls","aria-label":"Settings"},H("div",{class:"bar"},o,A),u,i.fields.length>0?b:null)}var ne=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],hn=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],Gt=(n,t)=>[t*n[0],t*n[1],t*n[2]],Ai=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Zi=n=>Math.hypot(n[0],n[1],n[2]),Ds=(n,t)=>Zi(hn(n,t)),Ji=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Qn=n=>Gt(n,1/(Zi(n)||1));function Wo(n,t,e){let[i,s]=[Math.sin(e),Math.cos(e)],r=Gt(t,Ai(t,n)*(1-s));return ne(ne(Gt(n,s),Gt(Ji(t,n),i)),r)}var al={x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]};function ol(n,t){return ne(ne(Gt(n.x,t[0]),Gt(n.y,t[1])),Gt(n.z,t[2]))}function Xo(n,t){return ne(n.o,ol(n,t))}function Yh({x:n,y:t,z:e,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:ne(Gt(n,a),Gt(t,o)),y:hn(Gt(t,a),Gt(n,o)),z:e,o:ne(i,Gt(e,s))}}function $h({x:n,y:t,z:e,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:n,y:ne(Gt(t,a),Gt(e,o)),z:hn(Gt(e,a),Gt(t,o)),o:ne(i,Gt(n,s))}}function kr(n,{xyz:t,rpy:e}){let[i,s,r]=e.map(Math.sin),[o,a,l]=e.map(Math.cos);return{x:ol(n,[l*a,r*a,-s]),y:ol(n,[l*s*i-r*o,r*s*i+l*o,a*i]),z:ol(n,[l*s*o+r*i,r*s*o-l*i,a*o]),o:Xo(n,t)}}function Zh(n){let t=Math.atan2(-n[2][0],Math.hypot(n[0][0],n[1][0]));return Math.hypot(n[0][0],n[1][0])<1e-9?[0,t,Math.atan2(-n[0][1],n[1][1])]:[Math.atan2(n[2][1],n[2][2]),t,Math.atan2(n[1][0],n[0][0])]}function Nf(n){if(n.length===1)return n[0];let{x:t,y:e,z:i,o:s}=n.reduce(kr,al),r=Zh([0,1,2].map(a=>[t[a],e[a],i[a]])),o=a=>a.map(l=>Math.abs(l)<1e-15?0:l);return{xyz:o(s),rpy:o(r)}}function __(n,t){return n.rows.map(e=>e.joint!==null?t[e.joint]:e.follows?e.follows.factor*t[e.follows.joint]+e.follows.offset:e.locked)}function zr(n,t){let e=n.base?kr(al,n.base):al,i=__(n,t),s=[];n.rows.forEach((o,a)=>{let l=o.on===null?e:s[o.on].frame,c=o.step.reduce(kr,l),u=o.type==="prismatic",d=o.theta+(u?0:i[a]),h=o.d+(u?i[a]:0),p=(x,g,m)=>{let y=o.mount?o.mount.frame.reduce(kr,g):g;s.push({before:c,middle:x,frame:g,link:y,theta:d,d:h,origin:m.o,axis:m.z})};if(n.convention==="standard"){let x=Yh(c,h,d);p(x,$h(x,o.a,o.alpha),c);return}let _=$h(c,o.a,o.alpha);p(_,Yh(_,h,d),_)});let r=n.tips.map(({on:o,places:a})=>a.reduce(kr,o===null?e:s[o].link));return{base:e,rows:s,tips:r}}function Uf(n,t){let e=new Array(n.dof).fill(0),{base:i,rows:s,tips:r}=zr(n,e),o=[],a=h=>h===null?{way:0,at:i.o}:o[h],l=({way:h,at:p},_)=>({way:h+Ds(p,_),at:_});s.forEach(({middle:h,frame:p,link:_},x)=>{let{on:g,isPlace:m}=n.rows[x],y=n.isMounted?m?[]:[_.o]:[h.o,p.o];o.push(y.reduce(l,a(g)))});let c=n.tips.map(({on:h},p)=>l(a(h),r[p].o).way),u=Math.max(0,...o.map(({way:h})=>h),...c)+t,d=n.rows.map(h=>Math.hypot(...h.com));return Math.max(u,...d)||1}function Ff(n,t){let e=Object.keys(n).filter(r=>/^[a-z]/.test(r)),i=n.FIELD_NAMES!==void 0,s=r=>i?(...o)=>n[r](t,...o):n[r];return Object.fromEntries(e.map(r=>[r,s(r)]))}function Of(n,{q:t,qd:e,qdd:i,tau:s},{key:r}){let o=n.gravity_vector(t),a=n.friction_vector(e),l=n.spring_vector(t),c=n.inverse_dynamics(t,e,t.map(()=>0));return{q:t,qd:e,qdd:i,tau:s,mass:n.mass_matrix(t),coriolis:c.map((u,d)=>u-o[d]-l[d]-a[d]),gravity:o,friction:a,spring:l,tip:n[r](t),kinetic:n.kinetic_energy(t,e),potential:n.potential_energy(t)}}var zf=n=>typeof n=="number"?[n]:n&&typeof n=="object"?Object.values(n).flatMap(zf):[];function Bf([n,t,e,i,s,r],o){return[[[n,t,e],o],[[n*t-i*i,t*e-s*s,n*e-r*r],o**2],[[n*(t*e-s*s)-i*(i*e-s*r)+r*(i*s-t*r)],o**3]].every(([l,c])=>l.every(u=>u>=-1e-9*c))}function x_([n,t,e,i,s,r]){let o=Math.max(...[n,t,e,i,s,r].map(Math.abs));if([n,t,e].filter(c=>c!==0).length<2&&Math.min(n,t,e)>=0&&i===0&&s===0&&r===0)return null;let a=(n+t+e)/2;return Bf([n,t,e,i,s,r],o)&&Bf([a-n,a-t,a-e,-i,-s,-r],o)?null:"no body has this inertia tensor"}function kf(n){if(zf(n).some(e=>!Number.isFinite(e)))return"division by zero, or a number that is too large";let t=[[n.mass,"a mass"],[n.motorInertia,"a motor's inertia"],[n.viscous,"a friction coefficient"],[Math.min(...n.coulomb??[]),"a friction torque or force"],[n.stribeck?.friction,"a friction torque or force"],[n.spring?.stiffness,"a spring's stiffness"]].find(([e])=>e<0);return t?`${t[1]} cannot be negative`:n.motorInertia>0&&n.gearRatio===0?"a gear ratio of zero: a motor with inertia turns with its joint":n.stribeck&&!(n.stribeck.velocity>0)?"a Stribeck velocity is above zero":x_(n.inertia)}function Vf(n,t){let e=({rows:s,tool:r,base:o,gravity:a})=>[...s,r,o&&{inertia:[0,0,0,0,0,0],base:o},{inertia:[0,0,0,0,0,0],gravity:a}],i=e(t);for(let[s,r]of e(n).entries()){let o=r&&kf(r);if(o&&o!==kf(i[s]))return r.name?`\`${r.name}\`: ${o}`:o}return null}function Gf(){let n=new Map;return{on(t,e){for(let i of t.split(" "))n.set(i,[...n.get(i)??[],e])},tell(t){(n.get(t)??[]).forEach(e=>e())}}}var Jh=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],ll=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]],[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]]],Hf=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],Wf=[[0,.2440944881889764],[8,.7338466882816118],[11,.022058823529411766]];var y_=1e-10;function qo(n,t,e,i){let s=Float64Array.from(n);for(let[r,o]of e){let a=i[r];for(let l=0;l<s.length;l++)s[l]+=t*o*a[l]}return s}function cl(n,t,e,i,s){let r=[i];for(let _=1;_<Jh.length;_++)r.push(n(t+Jh[_]*s,qo(e,s,ll[_],r)));let o=qo(e,s,ll[12],r),a=new Float64Array(e.length),l=qo(a,1,ll[12],r),c=qo(a,1,Wf,r),u=qo(a,1,Hf,r),[d,h]=[0,0];for(let _=0;_<e.length;_++){let x=y_*(1+Math.max(Math.abs(e[_]),Math.abs(o[_])));d+=(u[_]/x)**2/e.length,h+=((l[_]-c[_])/x)**2/e.length}let p=d===0?0:s*d/Math.sqrt(d+.01*h);return{end:o,error:p}}function jh(n,t){if(!Number.isFinite(n))return 1/3;let e=.9*n**(-1/8);return Math.min(Math.max(e,1/3),t?1:6)}function v_(n){let t=Array.from({length:n.dof},()=>[]);for(let e of n.rows)e.joint!==null?t[e.joint].push({row:e,factor:1}):e.follows&&t[e.follows.joint].push({row:e,factor:e.follows.factor});return t}var Xf=(n,t)=>t>0?n.coulomb[0]:n.coulomb[1],S_=(n,t)=>n.stribeck?n.stribeck.friction:Xf(n,t);function qf(n){let t=v_(n);return{isDry:t.map(e=>e.some(({row:i})=>i.coulomb[0]!==0||i.coulomb[1]!==0||i.stribeck!==null)),breakaway:(e,i)=>t[e].reduce((s,{row:r,factor:o})=>s+Math.abs(o)*S_(r,i*Math.sign(o)),0),sliding:(e,i,s)=>t[e].reduce((r,{row:o,factor:a})=>{let l=a*s,c=Math.sign(a)*i,u=Xf(o,c),d=o.stribeck?(o.stribeck.friction-u)*Math.exp(-((l/o.stribeck.velocity)**2)):0;return r+a*(o.viscous*l+c*(u+d))},0)}}var Yo=class extends Error{constructor(t){super(`not positive definite at index ${t}`),this.joint=t}};function Yf(n,t,e){let i=e.length,s=e.map(()=>new Array(i).fill(0)),r=e.map(o=>t[o]);for(let o=0;o<i;o++){for(let a=0;a<=o;a++){let l=n[e[o]][e[a]];for(let c=0;c<a;c++)l-=s[o][c]*s[a][c];if(o===a&&!(l>1e-14*Math.abs(n[e[o]][e[o]])))throw new Yo(e[o]);s[o][a]=o===a?Math.sqrt(l):l/s[a][a]}for(let a=0;a<o;a++)r[o]-=s[o][a]*r[a];r[o]/=s[o][o]}for(let o=i-1;o>=0;o--){for(let a=o+1;a<i;a++)r[o]-=s[a][o]*r[a];r[o]/=s[o][o]}return r}var M_=6e5,b_=200,w_={none:()=>(n,t)=>n.map(()=>0),constant:({torque:n})=>()=>n,gravity:({equations:n})=>t=>{let e=n.spring_vector(t);return n.gravity_vector(t).map((i,s)=>i+e[s])}};function E_(n,t){let{name:e}=n.rows.find(i=>i.joint===t);return`the mass matrix is singular at joint ${t+1}, \`${e}\`: no inertia resists its motion`}var Vr=class extends Error{},Kh=class{constructor(t,e,i,s){Cf(this,"rate",(t,e)=>{let i=this.dof,[s,r]=[Array.from(e.subarray(0,i)),Array.from(e.subarray(i,2*i))],{tau:o,friction:a,qdd:l}=this.solve(s,r),c=r.reduce((u,d,h)=>u+d*(o[h]-a[h]),0);return Float64Array.from([...r,...l,c])});this.equations=t,this.torque=i,this.hasFriction=s,this.dry=qf(e),this.dof=e.dof,this.evaluations=0,this.contacts=new Array(e.dof).fill(0),this.sticks=s&&this.dry.isDry.some(Boolean)}friction(t){return this.hasFriction?t.map((e,i)=>{let s=this.contacts[i];return s===null?0:this.dry.sliding(i,s||Math.sign(e),e)}):t.map(()=>0)}solve(t,e){if(++this.evaluations>M_)throw new Vr("it takes too many steps");let i=this.torque(t,e),s=this.friction(e);if(!this.contacts.includes(null)){let p=this.equations.friction_vector(e),_=i.map((x,g)=>x+(p[g]-s[g]));return{tau:i,friction:s,qdd:this.equations.forward_dynamics(t,e,_),hold:null}}let r=e.map(()=>0),o=this.equations.friction_vector(e),a=this.equations.inverse_dynamics(t,e,r).map((p,_)=>p-o[_]),l=this.equations.mass_matrix(t),c=this.contacts.flatMap((p,_)=>p===null?[]:[_]),u=i.map((p,_)=>p-a[_]-s[_]),d=r;Yf(l,u,c).forEach((p,_)=>d[c[_]]=p);let h=i.map((p,_)=>this.contacts[_]!==null?0:l[_].reduce((x,g,m)=>x-g*d[m],p-a[_]));return{tau:i,friction:s,qdd:d,hold:h}}split(t){let e=this.dof;return[Array.from(t.subarray(0,e)),Array.from(t.subarray(e,2*e))]}margins(t){if(!this.sticks)return[1/0];let[e,i]=this.split(t),s=this.contacts.includes(null)?this.solve(e,i).hold:null;return this.contacts.map((r,o)=>r===null?this.dry.breakaway(o,Math.sign(s[o]))-Math.abs(s[o]):r===0?1/0:r*i[o])}settle(t){if(!this.sticks)return;let[e,i]=this.split(t);for(this.contacts=i.map((s,r)=>this.dry.isDry[r]?s===0?null:Math.sign(s):0);this.contacts.includes(null);){let{hold:s}=this.solve(e,i),r=this.contacts.map((a,l)=>a!==null||s[l]===0?0:Math.abs(s[l])/this.dry.breakaway(l,Math.sign(s[l]))),o=r.indexOf(Math.max(...r));if(!(r[o]>1))return;this.contacts[o]=Math.sign(s[o])}}};function T_(n,t,e,i,s){let[r,o]=[0,s];for(let a=0;a<60&&o-r>1e-12*s;a++){let l=(r+o)/2,{end:c}=cl(n.rate,t,e,i,l);Math.min(...n.margins(c))<0?o=l:r=l}return o}function A_(n,t,e){let{t:i,y:s,h:r}=t,o=0,a=!1;for(;e-i>1e-12*Math.max(1,e);){let l=n.rate(i,s),c=Math.min(r,e-i),{end:u,error:d}=cl(n.rate,i,s,l,c);if(!(d<=1)){if(r=c*jh(d,!0),a=!0,!(r>1e-12))throw new Vr("its steps become too small");continue}if(Math.min(...n.margins(u))<0){if(++o>b_)throw new Vr("a joint sticks and lets go without end");let p=T_(n,i,s,l,c);s=cl(n.rate,i,s,l,p).end,i+=p,n.contacts.forEach((_,x)=>{_&&_*s[n.dof+x]<=0&&(s[n.dof+x]=0)}),n.settle(s);continue}[i,s]=[i+c,u];let h=c*jh(d,a);r=c<r&&d<.1?Math.max(r,h):h,a=!1}return{t:e,y:s,h:r}}function $f({equations:n,table:t,law:e,torque:i,hasFriction:s,q:r,qd:o,duration:a,samples:l}){let c=new Kh(n,t,w_[e]({equations:n,torque:i}),s),u={t:[],q:[],qd:[],qdd:[],tau:[],work:[],ended:null},d={t:0,y:Float64Array.from([...r,...o,0]),h:a/l};try{c.settle(d.y);for(let h=0;h<l;h++){let p=a*h/(l-1);d=A_(c,d,p);let[_,x]=c.split(d.y),{qdd:g,tau:m}=c.solve(_,x);u.t.push(p),u.q.push(_),u.qd.push(x),u.qdd.push(g),u.tau.push(m),u.work.push(d.y[2*c.dof])}}catch(h){let p=h instanceof Yo||h.name==="SingularMassMatrix";if(!(h instanceof Vr)&&!p)throw h;u.ended={t:d.t,reason:p?E_(t,h.joint):h.message}}return u}var $o=2*Math.PI,C_={cycloidal:n=>[n-Math.sin($o*n)/$o,1-Math.cos($o*n),$o*Math.sin($o*n)],quintic:n=>[n**3*(10+n*(6*n-15)),30*n**2*(1-n)**2,60*n*(1-n)*(1-2*n)],cubic:n=>[n*n*(3-2*n),6*n*(1-n),6-12*n]};function Zf({from:n,to:t,duration:e,profile:i},s){let[r,o,a]=C_[i](Math.min(Math.max(s/e,0),1)),l=c=>n.map((u,d)=>c(t[d]-u,u));return{q:l((c,u)=>u+c*r),qd:l(c=>c*o/e),qdd:l(c=>c*a/e**2)}}var R_=100,[P_,I_]=[201,2001];function Jf(n){return Math.min(Math.max(Math.round(R_*n)+1,P_),I_)}function jf(n,t){let e=Jf(t.duration),i=l=>{let c=Zf(t,l);return{...c,tau:n.inverse_dynamics(c.q,c.qd,c.qdd)}},s=Array.from({length:e},(l,c)=>t.duration*c/(e-1)),r=s.map(i),o=l=>r.map(c=>c[l]),a={t:s,q:o("q"),qd:o("qd"),qdd:o("qdd"),tau:o("tau")};return Qf(n,{...a,at:i,ended:null,duration:t.duration},t)}function Kf(n,t){let e=$f({...t,equations:n,samples:Jf(t.duration)});e.t.length===0&&L_(e,t);let i=e.t.length>0?e.t[e.t.length-1]:0,s=Qf(n,{...e,duration:i,at:u=>D_(e,u)},t),{total:r,kinetic:o,potential:a}=s,l=r.map((u,d)=>Math.abs(u-r[0]-e.work[d])),c=u=>Math.max(...u)-Math.min(...u);return s.drift=Math.max(0,...l),s.energyScale=Math.max(c(o),c(a),c(e.work),0),s}function L_(n,{q:t,qd:e}){let i=t.map(()=>NaN);for(let[s,r]of Object.entries({t:0,q:t,qd:e,qdd:i,tau:i,work:0}))n[s].push(r)}function Qf(n,t,{key:e}){let{q:i,qd:s}=t,r=i.map((c,u)=>n.kinetic_energy(c,s[u])),o=i.map(c=>n.potential_energy(c)),a=r.map((c,u)=>c+o[u]),l=i.map(c=>n[e](c).slice(0,3).map(u=>u[3]));return{...t,kinetic:r,potential:o,total:a,tip:l}}function D_(n,t){let{t:e}=n,i=e.length-1;if(i<1)return{q:n.q[0],qd:n.qd[0],qdd:n.qdd[0],tau:n.tau[0]};let s=e[1]-e[0],r=Math.min(Math.max(Math.floor(t/s),0),i-1),o=Math.min(Math.max((t-e[r])/s,0),1);if(o===0||o===1){let c=r+o;return{q:n.q[c],qd:n.qd[c],qdd:n.qdd[c],tau:n.tau[c]}}let a=(c,u)=>c[r].map((d,h)=>{let p=c[r+1][h]-d,[_,x]=[s*u[r][h]-p,p-s*u[r+1][h]];return d+o*(p+(1-o)*(_*(1-o)+x*o))}),l=c=>c[r].map((u,d)=>u+o*(c[r+1][d]-u));return{q:a(n.q,n.qd),qd:a(n.qd,n.qdd),qdd:l(n.qdd),tau:l(n.tau)}}function tp(n,t){let e=["q","qd","qdd","tau"],s=["t",...e.flatMap(o=>t.map(a=>`${o}_${a}`)),"kinetic","potential","x","y","z"],r=n.t.map((o,a)=>[o,...e.flatMap(l=>n[l][a]),n.kinetic[a],n.potential[a],...n.tip[a]]);return[s,...r].map(o=>o.join(",")).join(`
`)+`
`}var N_=30;function U_(n,t){return n.limits?n.limits:n.type==="revolute"?[-Math.PI,Math.PI]:[-t,t]}function F_([n,t]){return n<=0&&t>=0?0:(n+t)/2}var ep=[60,40,-50,30,70,-40];function O_(n,{type:t,joint:e},[i,s]){let r=ep[e%ep.length],o=t==="revolute"?r*Math.PI/180:(s-i)*r/240,[a,l]=[n+o,n-o],c=u=>u>=i&&u<=s;return c(a)?a:c(l)?l:o>0?s:i}function np(n,t,e){let{on:i,tell:s}=Gf(),r=Object.fromEntries(e.fields.map(({name:y,value:C})=>[y,C])),o=Ff(t,r),a=n(r),l=a.rows.filter(y=>y.type==="prismatic"&&y.joint!==null).reduce((y,C)=>y+(C.limits?Math.max(...C.limits.map(Math.abs)):0),0),c=Uf(a,l),u=a.rows.filter(y=>y.joint!==null),d=u.map(y=>U_(y,c)),h=u.map(()=>0),p=e.from??d.map(F_),_={mode:"motion",q:[...p],qd:[...h],qdd:[...h],end:e.to??p.map((y,C)=>O_(y,u[C],d[C])),torque:[...h],profile:"cycloidal",law:"none",hasFriction:!0,duration:e.duration,t:0,isPlaying:!1,isRepeated:!1,speed:1,selected:a.rows.indexOf(u[0]),tip:0,show:{parameters:"selected",frames:!1,axes:!1,masses:!1,trace:!0,names:!1}},x={on:i,tell:s,state:_,first:e,fields:r,equations:o,table:a,size:c,joints:u,ranges:d,trajectory:null,units:qh(!0),now(){if(_.mode==="pose"){let{q:y,qd:C,qdd:b}=_;return{q:y,qd:C,qdd:b,tau:o.inverse_dynamics(y,C,b)}}return x.trajectory.at(_.t)},tip:()=>a.tips[_.tip],evaluated:()=>Of(o,x.now(),x.tip()),frames:()=>zr(x.table,x.now().q),setTime(y){let C=x.trajectory?.duration??0;_.t=Math.min(Math.max(y,0),C),s("time")},play(y){x.trajectory&&(_.isPlaying=y,y&&_.t>=x.trajectory.duration&&x.setTime(0),s("play"))},setMode(y){_.mode=y,_.isPlaying=!1,_.t=0,x.recompute(),s("mode"),s("time"),s("play")},changed(){_.isPlaying=!1,_.t=0,s("play"),x.ask()},setFields(y){let C=n({...r,...y}),b=Vf(C,a);return b||(Object.assign(r,y),x.table=C,s("fields"),x.changed(),null)},setUnits(y){x.units=qh(y),s("units")},select(y){_.selected=y,s("selection")},setTip(y){_.tip=y,x.recompute(),s("tip")},setShown(y){Object.assign(_.show,y),s("show")},recompute(){let y=performance.now(),{q:C,qd:b,end:A,torque:M,profile:f,law:S,hasFriction:I,duration:R}=_,{table:P}=x,{key:U}=x.tip();x.trajectory=_.mode==="motion"?jf(o,{from:[...C],to:[...A],duration:R,profile:f,key:U}):_.mode==="free"?Kf(o,{table:P,law:S,hasFriction:I,duration:R,key:U,q:[...C],qd:[...b],torque:[...M]}):null,g=performance.now()-y,m=void 0,s("trajectory"),s("time")},isStale:()=>m!==void 0,ask(){clearTimeout(m),m=setTimeout(x.recompute,g>N_?160:0)}},[g,m]=[0,void 0];return x.recompute(),x}function or(n,t){return H("div",{class:"scroll",role:"region",tabIndex:0,"aria-label":n},t)}function ip(n){let{joints:t,table:e}=n,i=e.rows.some(A=>A.viscous||A.coulomb.some(Boolean)||A.stribeck),s=e.rows.some(A=>A.spring),r=[{key:"q",sign:"q",unit:"position",isAngle:!0},{key:"qd",sign:"q\u0307",unit:"velocity",isAngle:!0},{key:"qdd",sign:"q\u0308",unit:"acceleration",isAngle:!0},{key:"tau",sign:"\u03C4",unit:"force"},{key:"coriolis",sign:"V",unit:"force"},{key:"gravity",sign:"G",unit:"force"},...s?[{key:"spring",sign:"K",unit:"force"}]:[],...i?[{key:"friction",sign:"F",unit:"force"}]:[]],o=new Map,a=A=>{let M=Rf(A);return o.set(A,M),H("td",{},M)},l=[...new Set(t.map(A=>A.type))],c=r.map(()=>H("th",{class:"unit",scope:"col"})),u=H("table",{class:"numbers wide"},H("caption",{},"State and forces"),H("thead",{},H("tr",{},H("th",{scope:"col"},"joint"),r.map(({sign:A})=>H("th",{scope:"col"},H("i",{},A)))),H("tr",{},H("th",{class:"unit",scope:"col"},""),c)),H("tbody",{},t.map((A,M)=>{let f=H("th",{scope:"row"},H("span",{class:"dot"}),A.name);return f.style.setProperty("--color",`var(--joint-${M%8})`),H("tr",{},f,r.map(({key:S})=>a(`${S}-${M}`)))}))),h=l.length>1?"kg m\xB2, kg m, kg":l[0]==="revolute"?"kg m\xB2":"kg",p=H("table",{class:"numbers matrix"},H("caption",{},"Mass matrix ",H("i",{},"M"),`, ${h}`),H("tbody",{},t.map((A,M)=>H("tr",{},t.map((f,S)=>a(`mass-${M}-${S}`)))))),_=H("span",{},"Tip"),x=H("table",{class:"numbers"},H("caption",{},_," in the world"),H("tbody",{},["x","y","z"].map((A,M)=>H("tr",{},H("th",{scope:"row"},H("i",{},A)),a(`tip-${M}-3`),H("td",{class:"unit"},"m"),H("th",{scope:"row"},["roll","pitch","yaw"][M]),a(`rpy-${M}`),H("td",{class:"unit angle"}))))),g=H("details",{},H("summary",{},"Transform of the tip, 4 \xD7 4"),or("Transform of the tip",H("table",{class:"numbers matrix"},H("tbody",{},[0,1,2,3].map(A=>H("tr",{},[0,1,2,3].map(M=>a(`T-${A}-${M}`)))))))),m=H("table",{class:"numbers"},H("caption",{},"Energies, J"),H("tbody",{},[["T","kinetic"],["U","potential"],["T + U","total"]].map(([A,M])=>H("tr",{},H("th",{scope:"row"},H("i",{},A)),a(M))))),y=(A,M,f=1)=>Pf(o.get(A),M,Ho(M*f));function C(){let{units:A}=n,M=n.evaluated();e.tips.length>1&&(_.textContent=n.tip().name),t.forEach((S,I)=>{r.forEach(({key:R,isAngle:P})=>y(`${R}-${I}`,M[R][I],P?A.factor(S.type):1))});let f=M.mass.map((S,I)=>Math.abs(S[I]));t.forEach((S,I)=>t.forEach((R,P)=>{y(`mass-${I}-${P}`,M.mass[I][P]);let U=Math.abs(M.mass[I][P])/Math.sqrt(f[I]*f[P]);o.get(`mass-${I}-${P}`).parentElement.style.setProperty("--share",Number.isFinite(U)?Math.min(U,1).toFixed(3):0)})),M.tip.forEach((S,I)=>S.forEach((R,P)=>y(`T-${I}-${P}`,R))),[0,1,2].forEach(S=>y(`tip-${S}-3`,M.tip[S][3])),Zh(M.tip).forEach((S,I)=>y(`rpy-${I}`,S,A.factor("revolute"))),y("kinetic",M.kinetic),y("potential",M.potential),y("total",M.kinetic+M.potential)}function b(){r.forEach(({unit:A},M)=>{c[M].textContent=l.map(f=>n.units[A](f)).join(", ")}),x.querySelectorAll(".angle").forEach(A=>A.textContent=n.units.angleUnit),C()}return n.on("units",b),n.on("time tip",C),b(),H("section",{class:"panel","aria-label":"Numbers"},or("State and forces",u),H("div",{class:"blocks"},or("Mass matrix",p),or("Pose of the tip",x),or("Energies",m)),g)}var B_="uplot",k_="u-hz",z_="u-vt",V_="u-title",G_="u-wrap",H_="u-under",W_="u-over",X_="u-axis",cr="u-off",q_="u-select",Y_="u-cursor-x",$_="u-cursor-y",Z_="u-cursor-pt",J_="u-legend",j_="u-live",K_="u-inline",Q_="u-series",tx="u-marker",sp="u-label",ex="u-value",Jo="width",jo="height";var rp="bottom",Gr="left",Qh="right",gu="#000",op=gu+"0",tu="mousemove",ap="mousedown",eu="mouseup",lp="mouseenter",cp="mouseleave",hp="dblclick",nx="resize",ix="scroll",up="change",pl="dppxchange",_u="--",Zr=typeof window<"u",ou=Zr?document:null,Wr=Zr?window:null,sx=Zr?navigator:null,Ee,hl;function au(){let n=devicePixelRatio;Ee!=n&&(Ee=n,hl&&cu(up,hl,au),hl=matchMedia(`(min-resolution: ${Ee-.001}dppx) and (max-resolution: ${Ee+.001}dppx)`),hr(up,hl,au),Wr.dispatchEvent(new CustomEvent(pl)))}function li(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function lu(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Xe(n,t,e){n.style[t]=e+"px"}function Ci(n,t,e,i){let s=ou.createElement(n);return t!=null&&li(s,t),e?.insertBefore(s,i),s}function yi(n,t){return Ci("div",n,t)}var dp=new WeakMap;function ji(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=dp.get(n);r!=o&&(n.style.transform=r,dp.set(n,r),t<0||e<0||t>i||e>s?li(n,cr):lu(n,cr))}var fp=new WeakMap;function pp(n,t,e){let i=t+e,s=fp.get(n);i!=s&&(fp.set(n,i),n.style.background=t,n.style.borderColor=e)}var mp=new WeakMap;function gp(n,t,e,i){let s=t+""+e,r=mp.get(n);s!=r&&(mp.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var xu={passive:!0},rx={...xu,capture:!0};function hr(n,t,e,i){t.addEventListener(n,e,i?rx:xu)}function cu(n,t,e,i){t.removeEventListener(n,e,xu)}Zr&&au();function Ri(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ci((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Wp(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Xp=n=>n!=null,qp=n=>n!=null&&n>0,_l=Wp(Xp),ox=Wp(qp);function ax(n,t,e,i=0,s=!1){let r=s?ox:_l,o=s?qp:Xp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Oe,l??-Oe]}function xl(n,t,e,i){let s=yp(n),r=yp(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?ds:Yp,a=s==1?ci:vi,l=r==1?vi:ci,c=a(o(_n(n))),u=l(o(_n(t))),d=Xr(e,c),h=Xr(e,u);return e==10&&(c<0&&(d=Be(d,-c)),u<0&&(h=Be(h,-u))),i||e==2?(n=d*s,t=h*r):(n=jp(n,d),t=yl(t,h)),[n,t]}function yu(n,t,e,i){let s=xl(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var vu=.1,_p={mode:3,pad:vu},Qo={pad:0,soft:null,mode:0},lx={min:Qo,max:Qo};function ml(n,t,e,i){return vl(e)?xp(n,t,e):(Qo.pad=e,Qo.soft=i?0:null,Qo.mode=i?3:0,xp(n,t,lx))}function be(n,t){return n??t}function cx(n,t,e){for(t=be(t,0),e=be(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function xp(n,t,e){let i=e.min,s=e.max,r=be(i.pad,0),o=be(s.pad,0),a=be(i.hard,-Oe),l=be(s.hard,Oe),c=be(i.soft,Oe),u=be(s.soft,-Oe),d=be(i.mode,0),h=be(s.mode,0),p=t-n,_=ds(p),x=Hn(_n(n),_n(t)),g=ds(x),m=_n(g-_);(p<1e-24||m>10)&&(p=0,(n==0||t==0)&&(p=1e-24,d==2&&c!=Oe&&(r=0),h==2&&u!=-Oe&&(o=0)));let y=p||x||1e3,C=ds(y),b=Xr(10,ci(C)),A=y*(p==0?n==0?.1:1:r),M=Be(jp(n-A,b/10),24),f=n>=c&&(d==1||d==3&&M<=c||d==2&&M>=c)?c:Oe,S=Hn(a,M<f&&n>=f?f:Pi(f,M)),I=y*(p==0?t==0?.1:1:o),R=Be(yl(t+I,b/10),24),P=t<=u&&(h==1||h==3&&R>=u||h==2&&R<=u)?u:-Oe,U=Pi(l,R>P&&t<=P?P:Hn(P,R));return S==U&&S==0&&(U=100),[S,U]}var hx=new Intl.NumberFormat(Zr?sx.language:"en-US"),Su=n=>hx.format(n),hi=Math,fl=hi.PI,_n=hi.abs,ci=hi.floor,gn=hi.round,vi=hi.ceil,Pi=hi.min,Hn=hi.max,Xr=hi.pow,yp=hi.sign,ds=hi.log10,Yp=hi.log2,ux=(n,t=1)=>hi.sinh(n)*t,nu=(n,t=1)=>hi.asinh(n/t),Oe=1/0;function vp(n){return(ds((n^n>>31)-(n>>31))|0)+1}function hu(n,t,e){return Pi(Hn(n,t),e)}function $p(n){return typeof n=="function"}function xe(n){return $p(n)?n:()=>n}var dx=()=>{},Zp=n=>n,Jp=(n,t)=>t,fx=n=>null,Sp=n=>!0,Mp=(n,t)=>n==t,px=/\.\d*?(?=9{6,}|0{6,})/gm,ur=n=>{if(Qp(n)||Us.has(n))return n;let t=`${n}`,e=t.match(px);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ur(s)}e${r}`}return Be(n,i)};function ar(n,t){return ur(Be(ur(n/t))*t)}function yl(n,t){return ur(vi(ur(n/t))*t)}function jp(n,t){return ur(ci(ur(n/t))*t)}function Be(n,t=0){if(Qp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return gn(i)/e}var Us=new Map;function Kp(n){return((""+n).split(".")[1]||"").length}function ea(n,t,e,i){let s=[],r=i.map(Kp);for(let o=t;o<e;o++){let a=_n(o),l=Be(Xr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Be(u,d);s.push(h),Us.set(h,d)}}return s}var ta={},Mu=[],qr=[null,null],Ns=Array.isArray,Qp=Number.isInteger,mx=n=>n===void 0;function bp(n){return typeof n=="string"}function vl(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function gx(n){return n!=null&&typeof n=="object"}var _x=Object.getPrototypeOf(Uint8Array),tm="__proto__";function Yr(n,t=vl){let e;if(Ns(n)){let i=n.find(s=>s!=null);if(Ns(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Yr(n[s],t)}else e=n.slice()}else if(n instanceof _x)e=n.slice();else if(t(n)){e={};for(let i in n)i!=tm&&(e[i]=Yr(n[i],t))}else e=n;return e}function un(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=tm&&(vl(n[s])?un(n[s],Yr(i[s])):n[s]=Yr(i[s]))}return n}var xx=0,yx=1,vx=2;function Sx(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function Mx(n,t){if(Ex(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Tx(o[0])||(o=wx(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=t?t[o][c]:yx,p=[];for(let _=0;_<u.length;_++){let x=u[_],g=r.get(l[_]);x===null?h!=xx&&(d[g]=x,h==vx&&p.push(g)):d[g]=x}Sx(d,p,s),i.push(d)}}return i}var bx=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function wx(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Ex(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Tx(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Hn(1,ci((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var em=["January","February","March","April","May","June","July","August","September","October","November","December"],nm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function im(n){return n.slice(0,3)}var Ax=nm.map(im),Cx=em.map(im),Rx={MMMM:em,MMM:Cx,WWWW:nm,WWW:Ax};function Zo(n){return(n<10?"0":"")+n}function Px(n){return(n<10?"00":n<100?"0":"")+n}var Ix={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Zo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Zo(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Zo(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Zo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Zo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Px(n.getMilliseconds())};function bu(n,t){t=t||Rx;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?Ix[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Lx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Dx(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==Lx?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var sm=n=>n%1==0,gl=[1,2,2.5,5],Nx=ea(10,-32,0,gl),rm=ea(10,0,32,gl),Ux=rm.filter(sm),lr=Nx.concat(rm),wu=`
`,om="{YYYY}",wp=wu+om,am="{M}/{D}",Ko=wu+am,ul=Ko+"/{YY}",lm="{aa}",Fx="{h}:{mm}",Hr=Fx+lm,Ep=wu+Hr,Tp=":{ss}",Ae=null;function cm(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?ea(10,0,3,gl).filter(sm):ea(10,-3,0,gl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,om,Ae,Ae,Ae,Ae,Ae,Ae,1],[s*28,"{MMM}",wp,Ae,Ae,Ae,Ae,Ae,1],[s,am,wp,Ae,Ae,Ae,Ae,Ae,1],[i,"{h}"+lm,ul,Ae,Ko,Ae,Ae,Ae,1],[e,Hr,ul,Ae,Ko,Ae,Ae,Ae,1],[t,Tp,ul+" "+Hr,Ae,Ko+" "+Hr,Ae,Ep,Ae,1],[n,Tp+".{fff}",ul+" "+Hr,Ae,Ko+" "+Hr,Ae,Ep,Ae,1]];function u(d){return(h,p,_,x,g,m)=>{let y=[],C=g>=o,b=g>=r&&g<o,A=d(_),M=Be(A*n,3),f=iu(A.getFullYear(),C?0:A.getMonth(),b||C?1:A.getDate()),S=Be(f*n,3);if(b||C){let I=b?g/r:0,R=C?g/o:0,P=M==S?M:Be(iu(f.getFullYear()+R,f.getMonth()+I,1)*n,3),U=new Date(gn(P/n)),B=U.getFullYear(),D=U.getMonth();for(let k=0;P<=x;k++){let q=iu(B+R*k,D+I*k,1),O=q-d(Be(q*n,3));P=Be((+q+O)*n,3),P<=x&&y.push(P)}}else{let I=g>=s?s:g,R=ci(_)-ci(M),P=S+R+yl(M-S,I);y.push(P);let U=d(P),B=U.getHours()+U.getMinutes()/e+U.getSeconds()/i,D=g/i,k=h.axes[p]._space,q=m/k;for(;P=Be(P+g,n==1?0:3),!(P>x);)if(D>1){let O=ci(Be(B+D,6))%24,K=d(P).getHours()-O;K>1&&(K=-1),P-=K*i,B=(B+D)%24;let tt=y[y.length-1];Be((P-tt)/g,3)*q>=.7&&y.push(P)}else y.push(P)}return y}}return[l,c,u]}var[Ox,Bx,kx]=cm(1),[zx,Vx,Gx]=cm(.001);ea(2,-53,53,[1]);function Ap(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Cp(n,t){return(e,i,s,r,o)=>{let a=t.find(_=>o>=_[0])||t[t.length-1],l,c,u,d,h,p;return i.map(_=>{let x=n(_),g=x.getFullYear(),m=x.getMonth(),y=x.getDate(),C=x.getHours(),b=x.getMinutes(),A=x.getSeconds(),M=g!=l&&a[2]||m!=c&&a[3]||y!=u&&a[4]||C!=d&&a[5]||b!=h&&a[6]||A!=p&&a[7]||a[1];return l=g,c=m,u=y,d=C,h=b,p=A,M(x)})}}function Hx(n,t){let e=bu(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function iu(n,t,e){return new Date(n,t,e)}function Rp(n,t){return t(n)}var Wx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Pp(n,t){return(e,i,s,r)=>r==null?_u:t(n(i))}function Xx(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function qx(n,t){return n.series[t].fill(n,t)}var Yx={show:!0,live:!0,isolate:!1,mount:dx,markers:{show:!0,width:2,stroke:Xx,fill:qx,dash:"solid"},idx:null,idxs:null,values:[]};function $x(n,t){let e=n.cursor.points,i=yi(),s=e.size(n,t);Xe(i,Jo,s),Xe(i,jo,s);let r=s/-2;Xe(i,"marginLeft",r),Xe(i,"marginTop",r);let o=e.width(n,t,s);return o&&Xe(i,"borderWidth",o),i}function Zx(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Jx(n,t){let e=n.series[t].points;return e._stroke||e._fill}function jx(n,t){return n.series[t].points.size}var su=[0,0];function Kx(n,t,e){return su[0]=t,su[1]=e,su}function dl(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function ru(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var Qx={show:!0,x:!0,y:!0,lock:!1,move:Kx,points:{one:!1,show:$x,size:jx,width:0,stroke:Jx,fill:Zx},bind:{mousedown:dl,mouseup:dl,click:dl,dblclick:dl,mousemove:ru,mouseleave:ru,mouseenter:ru},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},hm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Eu=un({},hm,{filter:Jp}),um=un({},Eu,{size:10}),dm=un({},hm,{show:!1}),Tu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',fm="bold "+Tu,pm=1.5,Ip={show:!0,scale:"x",stroke:gu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fm,side:2,grid:Eu,ticks:um,border:dm,font:Tu,lineGap:pm,rotate:0},ty="Value",ey="Time",Lp={show:!0,scale:"x",auto:!1,sorted:1,min:Oe,max:-Oe,idxs:[]};function ny(n,t,e,i,s){return t.map(r=>r==null?"":Su(r))}function iy(n,t,e,i,s,r,o){let a=[],l=Us.get(s)||0;e=o?e:Be(yl(e,s),l);for(let c=e;c<=i;c=Be(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function uu(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?ds:Yp,u=ci(c(e));s=Xr(l,u),l==10&&(s=lr[Ri(s,lr)]);let d=e,h=s*l;l==10&&(h=lr[Ri(h,lr)]);do a.push(d),d=d+s,l==10&&!Us.has(d)&&(d=Be(d,Us.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=lr[Ri(h,lr)]));while(d<=i);return a}function sy(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?uu(n,t,Hn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?uu(n,t,Hn(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(u,c)}var mm=/./,ry=/[12357]/,oy=/[125]/,Dp=/1/,du=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function ay(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?mm:l(7,o)-u>=c?ry:l(5,o)-u>=c?oy:Dp;if(d==Dp){let h=_n(l(1,o)-u);if(h<c)return du(t.slice().reverse(),a.distr,d,vi(c/h)).reverse()}return du(t,a.distr,d,1)}function ly(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=_n(l(1,o)-l(2,o));return c<a?du(t.slice().reverse(),3,mm,vi(a/c)).reverse():t}function cy(n,t,e,i){return i==null?_u:t==null?"":Su(t)}var Np={show:!0,scale:"y",stroke:gu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fm,side:3,grid:Eu,ticks:um,border:dm,font:Tu,lineGap:pm,rotate:0};function hy(n,t){let e=3+(n||1)*2;return Be(e*t,3)}function uy(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=_n(o-r),l=n.series[t],c=a/(l.points.space*Ee);return i[1]-i[0]<=c}var Up={scale:null,auto:!0,sorted:0,min:Oe,max:-Oe},gm=(n,t,e,i,s)=>s,Fp={show:!0,auto:!0,sorted:0,gaps:gm,alpha:1,facets:[un({},Up,{scale:"x"}),un({},Up,{scale:"y"})]},Op={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:gm,alpha:1,points:{show:uy,filter:null},values:null,min:Oe,max:-Oe,idxs:[],path:null,clip:null};function dy(n,t,e,i,s){return e/10}var _m={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},fy=un({},_m,{time:!1,ori:1}),Bp={};function xm(n,t){let e=Bp[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Bp[n]=e)),e}var $r=1,fu=2;function dr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,p=a.top,_=a.width,x=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,l,c,u,d,g,m,h,p,_,x,Ml,Jr,wl,vm,Mm):e(s,l,c,u,d,m,g,p,h,x,_,bl,jr,Ru,Sm,bm)}function Au(n,t){let e=0,i=0,s=be(n.bands,Mu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function py(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function fs(n,t,e,i,s,r){return dr(n,t,(o,a,l,c,u,d,h,p,_,x,g)=>{let m=o.pxRound,y=c.dir*(c.ori==0?1:-1),C=c.ori==0?Jr:jr,b,A;y==1?(b=e,A=i):(b=i,A=e);let M=m(d(a[b],c,x,p)),f=m(h(l[b],u,g,_)),S=m(d(a[A],c,x,p)),I=m(h(r==1?u.max:u.min,u,g,_)),R=new Path2D(s);return C(R,S,I),C(R,M,I),C(R,M,f),R})}function Sl(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?wl:Ru,l=e;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let p=h[0]-l;p>0&&a(o,l,i,p,i+r),l=h[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function my(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Cu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let p=r(n[d]),_=h==d?p:r(n[h]),x=d-s;p=o<=0&&x>=0&&x<l?r(n[x]):p;let m=h+s;_=o>=0&&m>=0&&m<l?r(n[m]):_,_>=p&&a.push([p,_])}return a}function kp(n){return n==0?Zp:n==1?gn:t=>ar(t,n)}function ym(n){let t=n==0?Ml:bl,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Pi(c,a/2,l/2),u=Pi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Ml=(n,t,e)=>{n.moveTo(t,e)},bl=(n,t,e)=>{n.moveTo(e,t)},Jr=(n,t,e)=>{n.lineTo(t,e)},jr=(n,t,e)=>{n.lineTo(e,t)},wl=ym(0),Ru=ym(1),vm=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Sm=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Mm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},bm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function wm(n){return(t,e,i,s,r)=>dr(t,e,(o,a,l,c,u,d,h,p,_,x,g)=>{let{pxRound:m,points:y}=o,C,b;c.ori==0?(C=Ml,b=vm):(C=bl,b=Sm);let A=Be(y.width*Ee,3),M=(y.size-y.width)/2*Ee,f=Be(M*2,3),S=new Path2D,I=new Path2D,{left:R,top:P,width:U,height:B}=t.bbox;wl(I,R-f,P-f,U+f*2,B+f*2);let D=k=>{if(l[k]!=null){let q=m(d(a[k],c,x,p)),O=m(h(l[k],u,g,_));C(S,q+M,O),b(S,q,O,M,0,fl*2)}};if(r)r.forEach(D);else for(let k=i;k<=s;k++)D(k);return{stroke:A>0?S:null,fill:S,clip:I,flags:$r|fu}})}function Em(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var gy=Em(Jr),_y=Em(jr);function Tm(n){let t=be(n?.alignGaps,0);return(e,i,s,r)=>dr(e,i,(o,a,l,c,u,d,h,p,_,x,g)=>{[s,r]=_l(l,s,r);let m=o.pxRound,y=B=>m(d(B,c,x,p)),C=B=>m(h(B,u,g,_)),b,A;c.ori==0?(b=Jr,A=gy):(b=jr,A=_y);let M=c.dir*(c.ori==0?1:-1),f={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:$r},S=f.stroke,I=!1;if(r-s>=x*4){let B=et=>e.posToVal(et,c.key,!0),D=null,k=null,q,O,it,Y=y(a[M==1?s:r]),K=y(a[s]),tt=y(a[r]),ht=B(M==1?K+1:tt-1);for(let et=M==1?s:r;et>=s&&et<=r;et+=M){let $=a[et],gt=(M==1?$<ht:$>ht)?Y:y($),vt=l[et];gt==Y?vt!=null?(O=vt,D==null?(b(S,gt,C(O)),q=D=k=O):O<D?D=O:O>k&&(k=O)):vt===null&&(I=!0):(D!=null&&A(S,Y,C(D),C(k),C(q),C(O)),vt!=null?(O=vt,b(S,gt,C(O)),D=k=q=O):(D=k=null,vt===null&&(I=!0)),Y=gt,ht=B(Y+M))}D!=null&&D!=k&&it!=Y&&A(S,Y,C(D),C(k),C(q),C(O))}else for(let B=M==1?s:r;B>=s&&B<=r;B+=M){let D=l[B];D===null?I=!0:D!=null&&b(S,y(a[B]),C(D))}let[P,U]=Au(e,i);if(o.fill!=null||P!=0){let B=f.fill=new Path2D(S),D=o.fillTo(e,i,o.min,o.max,P),k=C(D),q=y(a[s]),O=y(a[r]);M==-1&&([O,q]=[q,O]),b(B,O,k),b(B,q,k)}if(!o.spanGaps){let B=[];I&&B.push(...Cu(a,l,s,r,M,y,t)),f.gaps=B=o.gaps(e,i,s,r,B),f.clip=Sl(B,c.ori,p,_,x,g)}return U!=0&&(f.band=U==2?[fs(e,i,s,r,S,-1),fs(e,i,s,r,S,1)]:fs(e,i,s,r,S,U)),f})}function xy(n){let t=be(n.align,1),e=be(n.ascDesc,!1),i=be(n.alignGaps,0),s=be(n.extend,!1);return(r,o,a,l)=>dr(r,o,(c,u,d,h,p,_,x,g,m,y,C)=>{[a,l]=_l(d,a,l);let b=c.pxRound,{left:A,width:M}=r.bbox,f=K=>b(_(K,h,y,g)),S=K=>b(x(K,p,C,m)),I=h.ori==0?Jr:jr,R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:$r},P=R.stroke,U=h.dir*(h.ori==0?1:-1),B=S(d[U==1?a:l]),D=f(u[U==1?a:l]),k=D,q=D;s&&t==-1&&(q=A,I(P,q,B)),I(P,D,B);for(let K=U==1?a:l;K>=a&&K<=l;K+=U){let tt=d[K];if(tt==null)continue;let ht=f(u[K]),et=S(tt);t==1?I(P,ht,B):I(P,k,et),I(P,ht,et),B=et,k=ht}let O=k;s&&t==1&&(O=A+M,I(P,O,B));let[it,Y]=Au(r,o);if(c.fill!=null||it!=0){let K=R.fill=new Path2D(P),tt=c.fillTo(r,o,c.min,c.max,it),ht=S(tt);I(K,O,ht),I(K,q,ht)}if(!c.spanGaps){let K=[];K.push(...Cu(u,d,a,l,U,f,i));let tt=c.width*Ee/2,ht=e||t==1?tt:-tt,et=e||t==-1?-tt:tt;K.forEach($=>{$[0]+=ht,$[1]+=et}),R.gaps=K=c.gaps(r,o,a,l,K),R.clip=Sl(K,h.ori,g,m,y,C)}return Y!=0&&(R.band=Y==2?[fs(r,o,a,l,P,-1),fs(r,o,a,l,P,1)]:fs(r,o,a,l,P,Y)),R})}function zp(n,t,e,i,s,r,o=Oe){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=_n(n[l]-n[a]);u<c&&(c=u,o=_n(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function yy(n){n=n||ta;let t=be(n.size,[.6,Oe,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xe(s),o=1-t[0],a=be(t[1],Oe),l=be(t[2],1),c=be(n.disp,ta),u=be(n.each,p=>{}),{fill:d,stroke:h}=c;return(p,_,x,g)=>dr(p,_,(m,y,C,b,A,M,f,S,I,R,P)=>{let U=m.pxRound,B=e,D=i*Ee,k=a*Ee,q=l*Ee,O,it;b.ori==0?[O,it]=r(p,_):[it,O]=r(p,_);let Y=b.dir*(b.ori==0?1:-1),K=b.ori==0?wl:Ru,tt=b.ori==0?u:(Rt,Zt,oe,wt,Fe,Ht,Yt)=>{u(Rt,Zt,oe,Fe,wt,Yt,Ht)},ht=be(p.bands,Mu).find(Rt=>Rt.series[0]==_),et=ht!=null?ht.dir:0,$=m.fillTo(p,_,m.min,m.max,et),ft=U(f($,A,P,I)),gt,vt,_t,Ft=R,qt=U(m.width*Ee),Ot=!1,ce=null,he=null,Kt=null,Ye=null;d!=null&&(qt==0||h!=null)&&(Ot=!0,ce=d.values(p,_,x,g),he=new Map,new Set(ce).forEach(Rt=>{Rt!=null&&he.set(Rt,new Path2D)}),qt>0&&(Kt=h.values(p,_,x,g),Ye=new Map,new Set(Kt).forEach(Rt=>{Rt!=null&&Ye.set(Rt,new Path2D)})));let{x0:ke,size:sn}=c;if(ke!=null&&sn!=null){B=1,y=ke.values(p,_,x,g),ke.unit==2&&(y=y.map(oe=>p.posToVal(S+oe*R,b.key,!0)));let Rt=sn.values(p,_,x,g);sn.unit==2?vt=Rt[0]*R:vt=M(Rt[0],b,R,S)-M(0,b,R,S),Ft=zp(y,C,M,b,R,S,Ft),_t=Ft-vt+D}else Ft=zp(y,C,M,b,R,S,Ft),_t=Ft*o+D,vt=Ft-_t;_t<1&&(_t=0),qt>=vt/2&&(qt=0),_t<5&&(U=Zp);let Ne=_t>0,Sn=Ft-_t-(Ne?qt:0);vt=U(hu(Sn,q,k)),gt=(B==0?vt/2:B==Y?0:vt)-B*Y*((B==0?D/2:0)+(Ne?qt/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},pn=Ot?null:new Path2D,Je=null;if(ht!=null)Je=p.data[ht.series[1]];else{let{y0:Rt,y1:Zt}=c;Rt!=null&&Zt!=null&&(C=Zt.values(p,_,x,g),Je=Rt.values(p,_,x,g))}let rn=O*vt,V=it*vt;for(let Rt=Y==1?x:g;Rt>=x&&Rt<=g;Rt+=Y){let Zt=C[Rt];if(Zt==null)continue;if(Je!=null){let Z=Je[Rt]??0;if(Zt-Z==0)continue;ft=f(Z,A,P,I)}let oe=b.distr!=2||c!=null?y[Rt]:Rt,wt=M(oe,b,R,S),Fe=f(be(Zt,$),A,P,I),Ht=U(wt-gt),Yt=U(Hn(Fe,ft)),L=U(Pi(Fe,ft)),w=Yt-L;if(Zt!=null){let Z=Zt<0?V:rn,dt=Zt<0?rn:V;Ot?(qt>0&&Kt[Rt]!=null&&K(Ye.get(Kt[Rt]),Ht,L+ci(qt/2),vt,Hn(0,w-qt),Z,dt),ce[Rt]!=null&&K(he.get(ce[Rt]),Ht,L+ci(qt/2),vt,Hn(0,w-qt),Z,dt)):K(pn,Ht,L+ci(qt/2),vt,Hn(0,w-qt),Z,dt),tt(p,_,Rt,Ht-qt/2,L,vt+qt,w)}}return qt>0?ve.stroke=Ot?Ye:pn:Ot||(ve._fill=m.width==0?m._fill:m._stroke??m._fill,ve.width=0),ve.fill=Ot?he:pn,ve})}function vy(n,t){let e=be(t?.alignGaps,0);return(i,s,r,o)=>dr(i,s,(a,l,c,u,d,h,p,_,x,g,m)=>{[r,o]=_l(c,r,o);let y=a.pxRound,C=O=>y(h(O,u,g,_)),b=O=>y(p(O,d,m,x)),A,M,f;u.ori==0?(A=Ml,f=Jr,M=Mm):(A=bl,f=jr,M=bm);let S=u.dir*(u.ori==0?1:-1),I=C(l[S==1?r:o]),R=I,P=[],U=[];for(let O=S==1?r:o;O>=r&&O<=o;O+=S)if(c[O]!=null){let Y=l[O],K=C(Y);P.push(R=K),U.push(b(c[O]))}let B={stroke:n(P,U,A,f,M,y),fill:null,clip:null,band:null,gaps:null,flags:$r},D=B.stroke,[k,q]=Au(i,s);if(a.fill!=null||k!=0){let O=B.fill=new Path2D(D),it=a.fillTo(i,s,a.min,a.max,k),Y=b(it);f(O,R,Y),f(O,I,Y)}if(!a.spanGaps){let O=[];O.push(...Cu(l,c,r,o,S,C,e)),B.gaps=O=a.gaps(i,s,r,o,O),B.clip=Sl(O,u.ori,_,x,g,m)}return q!=0&&(B.band=q==2?[fs(i,s,r,o,D,-1),fs(i,s,r,o,D,1)]:fs(i,s,r,o,D,q)),B})}function Sy(n){return vy(My,n)}function My(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=t[h+1]-t[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,t[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,t[h+1]-l[h+1]*d[h]/3,n[h+1],t[h+1])}return a}var pu=new Set;function Vp(){for(let n of pu)n.syncRect(!0)}Zr&&(hr(nx,Wr,Vp),hr(ix,Wr,Vp,!0),hr(pl,Wr,()=>{Cn.pxRatio=Ee}));var by=Tm(),wy=wm();function Gp(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>mu(r,o,t,e))}function Ey(n,t){return n.map((e,i)=>i==0?{}:un({},t,e))}function mu(n,t,e,i){return un({},t==0?e:i,n)}function Am(n,t,e){return t==null?qr:[t,e]}var Ty=Am;function Ay(n,t,e){return t==null?qr:ml(t,e,vu,!0)}function Cm(n,t,e,i){return t==null?qr:xl(t,e,n.scales[i].log,!1)}var Cy=Cm;function Rm(n,t,e,i){return t==null?qr:yu(t,e,n.scales[i].log,!1)}var Ry=Rm;function Py(n,t,e,i,s){let r=Hn(vp(n),vp(t)),o=t-n,a=Ri(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Us.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Hp(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=gn((e=+s)*Ee))+"px"),[n,t,e]}function Iy(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Be(t[2]*Ee,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Cn(n,t,e){let i={mode:be(n.mode,1)},s=i.mode;function r(v,E,N,F){let W=E.valToPct(v);return F+N*(E.dir==-1?1-W:W)}function o(v,E,N,F){let W=E.valToPct(v);return F+N*(E.dir==-1?W:1-W)}function a(v,E,N,F){return E.ori==0?r(v,E,N,F):o(v,E,N,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=yi(B_);if(n.id!=null&&(c.id=n.id),li(c,n.class),n.title){let v=yi(V_,c);v.textContent=n.title}let u=Ci("canvas"),d=i.ctx=u.getContext("2d"),h=yi(G_,c);hr("click",h,v=>{v.target===_&&(Ge!=Nr||$e!=Ur)&&An.click(i,v)},!0);let p=i.under=yi(H_,h);h.appendChild(u);let _=i.over=yi(W_,h);n=Yr(n);let x=+be(n.pxAlign,1),g=kp(x);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let m=n.ms||.001,y=i.series=s==1?Gp(n.series||[],Lp,Op,!1):Ey(n.series||[null],Fp),C=i.axes=Gp(n.axes||[],Ip,Np,!0),b=i.scales={},A=i.bands=n.bands||[];A.forEach(v=>{v.fill=xe(v.fill||null),v.dir=be(v.dir,-1)});let M=s==2?y[1].facets[0].scale:y[0].scale,f={axes:hs,series:me},S=(n.drawOrder||["axes","series"]).map(v=>f[v]);function I(v){let E=v.distr==3?N=>ds(N>0?N:v.clamp(i,N,v.min,v.max,v.key)):v.distr==4?N=>nu(N,v.asinh):v.distr==100?N=>v.fwd(N):N=>N;return N=>{let F=E(N),{_min:W,_max:Q}=v,ct=Q-W;return(F-W)/ct}}function R(v){let E=b[v];if(E==null){let N=(n.scales||ta)[v]||ta;if(N.from!=null){R(N.from);let F=un({},b[N.from],N,{key:v});F.valToPct=I(F),b[v]=F}else{E=b[v]=un({},v==M?_m:fy,N),E.key=v;let F=E.time,W=E.range,Q=Ns(W);if((v!=M||s==2&&!F)&&(Q&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?_p:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?_p:{mode:1,hard:W[1],soft:W[1]}},Q=!1),!Q&&vl(W))){let ct=W;W=(pt,Mt,Dt)=>Mt==null?qr:ml(Mt,Dt,ct)}E.range=xe(W||(F?Ty:v==M?E.distr==3?Cy:E.distr==4?Ry:Am:E.distr==3?Cm:E.distr==4?Rm:Ay)),E.auto=xe(Q?!1:E.auto),E.clamp=xe(E.clamp||dy),E._min=E._max=null,E.valToPct=I(E)}}}R("x"),R("y"),s==1&&y.forEach(v=>{R(v.scale)}),C.forEach(v=>{R(v.scale)});for(let v in n.scales)R(v);let P=b[M],U=P.distr,B,D;P.ori==0?(li(c,k_),B=r,D=o):(li(c,z_),B=o,D=r);let k={};for(let v in b){let E=b[v];(E.min!=null||E.max!=null)&&(k[v]={min:E.min,max:E.max},E.min=E.max=null)}let q=n.tzDate||(v=>new Date(gn(v/m))),O=n.fmtDate||bu,it=m==1?kx(q):Gx(q),Y=Cp(q,Ap(m==1?Bx:Vx,O)),K=Pp(q,Rp(Wx,O)),tt=[],ht=i.legend=un({},Yx,n.legend),et=i.cursor=un({},Qx,{drag:{y:s==2}},n.cursor),$=ht.show,ft=et.show,gt=ht.markers;ht.idxs=tt,gt.width=xe(gt.width),gt.dash=xe(gt.dash),gt.stroke=xe(gt.stroke),gt.fill=xe(gt.fill);let vt,_t,Ft,qt=[],Ot=[],ce,he=!1,Kt={};if(ht.live){let v=y[1]?y[1].values:null;he=v!=null,ce=he?v(i,1,0):{_:0};for(let E in ce)Kt[E]=_u}if($)if(vt=Ci("table",J_,c),Ft=Ci("tbody",null,vt),ht.mount(i,vt),he){_t=Ci("thead",null,vt,Ft);let v=Ci("tr",null,_t);Ci("th",null,v);for(var Ye in ce)Ci("th",sp,v).textContent=Ye}else li(vt,K_),ht.live&&li(vt,j_);let ke={show:!0},sn={show:!1};function Ne(v,E){if(E==0&&(he||!ht.live||s==2))return qr;let N=[],F=Ci("tr",Q_,Ft,Ft.childNodes[E]);li(F,v.class),v.show||li(F,cr);let W=Ci("th",null,F);if(gt.show){let pt=yi(tx,W);if(E>0){let Mt=gt.width(i,E);Mt&&(pt.style.border=Mt+"px "+gt.dash(i,E)+" "+gt.stroke(i,E)),pt.style.background=gt.fill(i,E)}}let Q=yi(sp,W);v.label instanceof HTMLElement?Q.appendChild(v.label):Q.textContent=v.label,E>0&&(gt.show||(Q.style.color=v.width>0?gt.stroke(i,E):gt.fill(i,E)),ve("click",W,pt=>{if(et._lock)return;Qt(pt);let Mt=y.indexOf(v);if((pt.ctrlKey||pt.metaKey)!=ht.isolate){let Dt=y.some((Nt,Bt)=>Bt>0&&Bt!=Mt&&Nt.show);y.forEach((Nt,Bt)=>{Bt>0&&Xi(Bt,Dt?Bt==Mt?ke:sn:ke,!0,cn.setSeries)})}else Xi(Mt,{show:!v.show},!0,cn.setSeries)},!1),te&&ve(lp,W,pt=>{et._lock||(Qt(pt),Xi(y.indexOf(v),Or,!0,cn.setSeries))},!1));for(var ct in ce){let pt=Ci("td",ex,F);pt.textContent="--",N.push(pt)}return[F,N]}let Sn=new Map;function ve(v,E,N,F=!0){let W=Sn.get(E)||{},Q=et.bind[v](i,E,N,F);Q&&(hr(v,E,W[v]=Q),Sn.set(E,W))}function pn(v,E,N){let F=Sn.get(E)||{};for(let W in F)(v==null||W==v)&&(cu(W,E,F[W]),delete F[W]);v==null&&Sn.delete(E)}let Je=0,rn=0,V=0,Rt=0,Zt=0,oe=0,wt=Zt,Fe=oe,Ht=V,Yt=Rt,L=0,w=0,Z=0,dt=0;i.bbox={};let lt=!1,yt=!1,St=!1,st=!1,ot=!1,mt=!1;function z(v,E,N){(N||v!=i.width||E!=i.height)&&at(v,E),de(!1),St=!0,yt=!0,Dn()}function at(v,E){i.width=Je=V=v,i.height=rn=Rt=E,Zt=oe=0,bt(),Wt();let N=i.bbox;L=N.left=ar(Zt*Ee,.5),w=N.top=ar(oe*Ee,.5),Z=N.width=ar(V*Ee,.5),dt=N.height=ar(Rt*Ee,.5)}let rt=3;function Et(){let v=!1,E=0;for(;!v;){E++;let N=Ir(E),F=Wi(E);v=E==rt||N&&F,v||(at(i.width,i.height),yt=!0)}}function xt({width:v,height:E}){z(v,E)}i.setSize=xt;function bt(){let v=!1,E=!1,N=!1,F=!1;C.forEach((W,Q)=>{if(W.show&&W._show){let{side:ct,_size:pt}=W,Mt=ct%2,Dt=W.label!=null?W.labelSize:0,Nt=pt+Dt;Nt>0&&(Mt?(V-=Nt,ct==3?(Zt+=Nt,F=!0):N=!0):(Rt-=Nt,ct==0?(oe+=Nt,v=!0):E=!0))}}),Gi[0]=v,Gi[1]=N,Gi[2]=E,Gi[3]=F,V-=wi[1]+wi[3],Zt+=wi[3],Rt-=wi[2]+wi[0],oe+=wi[0]}function Wt(){let v=Zt+V,E=oe+Rt,N=Zt,F=oe;function W(Q,ct){switch(Q){case 1:return v+=ct,v-ct;case 2:return E+=ct,E-ct;case 3:return N-=ct,N+ct;case 0:return F-=ct,F+ct}}C.forEach((Q,ct)=>{if(Q.show&&Q._show){let pt=Q.side;Q._pos=W(pt,Q._size),Q.label!=null&&(Q._lpos=W(pt,Q.labelSize))}})}if(et.dataIdx==null){let v=et.hover,E=v.skip=new Set(v.skip??[]);E.add(void 0);let N=v.prox=xe(v.prox),F=v.bias??=0;et.dataIdx=(W,Q,ct,pt)=>{if(Q==0)return ct;let Mt=ct,Dt=N(W,Q,ct,pt)??Oe,Nt=Dt>=0&&Dt<Oe,Bt=P.ori==0?V:Rt,re=et.left,we=t[0],Me=t[Q];if(E.has(Me[ct])){Mt=null;let ge=null,jt=null,Xt;if(F==0||F==-1)for(Xt=ct;ge==null&&Xt-- >0;)E.has(Me[Xt])||(ge=Xt);if(F==0||F==1)for(Xt=ct;jt==null&&Xt++<Me.length;)E.has(Me[Xt])||(jt=Xt);if(ge!=null||jt!=null)if(Nt){let We=ge==null?-1/0:B(we[ge],P,Bt,0),Qe=jt==null?1/0:B(we[jt],P,Bt,0),En=re-We,Ue=Qe-re;En<=Ue?En<=Dt&&(Mt=ge):Ue<=Dt&&(Mt=jt)}else Mt=jt==null?ge:ge==null?jt:ct-ge<=jt-ct?ge:jt}else Nt&&_n(re-B(we[ct],P,Bt,0))>Dt&&(Mt=null);return Mt}}let Qt=v=>{et.event=v};et.idxs=tt,et._lock=!1;let ut=et.points;ut.show=xe(ut.show),ut.size=xe(ut.size),ut.stroke=xe(ut.stroke),ut.width=xe(ut.width),ut.fill=xe(ut.fill);let kt=i.focus=un({},n.focus||{alpha:.3},et.focus),te=kt.prox>=0,Ct=te&&ut.one,ue=[],Ve=[],Bn=[];function Uo(v,E){let N=ut.show(i,E);if(N instanceof HTMLElement)return li(N,Z_),li(N,v.class),ji(N,-10,-10,V,Rt),_.insertBefore(N,ue[E]),N}function Cr(v,E){if(s==1||E>0){let N=s==1&&b[v.scale].time,F=v.value;v.value=N?bp(F)?Pp(q,Rp(F,O)):F||K:F||cy,v.label=v.label||(N?ey:ty)}if(Ct||E>0){v.width=v.width==null?1:v.width,v.paths=v.paths||by||fx,v.fillTo=xe(v.fillTo||py),v.pxAlign=+be(v.pxAlign,x),v.pxRound=kp(v.pxAlign),v.stroke=xe(v.stroke||null),v.fill=xe(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let N=hy(Hn(1,v.width),1),F=v.points=un({},{size:N,width:Hn(1,N*.2),stroke:v.stroke,space:N*2,paths:wy,_stroke:null,_fill:null},v.points);F.show=xe(F.show),F.filter=xe(F.filter),F.fill=xe(F.fill),F.stroke=xe(F.stroke),F.paths=xe(F.paths),F.pxAlign=v.pxAlign}if($){let N=Ne(v,E);qt.splice(E,0,N[0]),Ot.splice(E,0,N[1]),ht.values.push(null)}if(ft){tt.splice(E,0,null);let N=null;Ct?E==0&&(N=Uo(v,E)):E>0&&(N=Uo(v,E)),ue.splice(E,0,N),Ve.splice(E,0,0),Bn.splice(E,0,0)}wn("addSeries",E)}function Uh(v,E){E=E??y.length,v=s==1?mu(v,E,Lp,Op):mu(v,E,{},Fp),y.splice(E,0,v),Cr(y[E],E)}i.addSeries=Uh;function nl(v){if(y.splice(v,1),$){ht.values.splice(v,1),Ot.splice(v,1);let E=qt.splice(v,1)[0];pn(null,E.firstChild),E.remove()}ft&&(tt.splice(v,1),ue.splice(v,1)[0].remove(),Ve.splice(v,1),Bn.splice(v,1)),wn("delSeries",v)}i.delSeries=nl;let Gi=[!1,!1,!1,!1];function as(v,E){if(v._show=v.show,v.show){let N=v.side%2,F=b[v.scale];F==null&&(v.scale=N?y[1].scale:M,F=b[v.scale]);let W=F.time;v.size=xe(v.size),v.space=xe(v.space),v.rotate=xe(v.rotate),Ns(v.incrs)&&v.incrs.forEach(ct=>{!Us.has(ct)&&Us.set(ct,Kp(ct))}),v.incrs=xe(v.incrs||(F.distr==2?Ux:W?m==1?Ox:zx:lr)),v.splits=xe(v.splits||(W&&F.distr==1?it:F.distr==3?uu:F.distr==4?sy:iy)),v.stroke=xe(v.stroke),v.grid.stroke=xe(v.grid.stroke),v.ticks.stroke=xe(v.ticks.stroke),v.border.stroke=xe(v.border.stroke);let Q=v.values;v.values=Ns(Q)&&!Ns(Q[0])?xe(Q):W?Ns(Q)?Cp(q,Ap(Q,O)):bp(Q)?Hx(q,Q):Q||Y:Q||ny,v.filter=xe(v.filter||(F.distr>=3&&F.log==10?ay:F.distr==3&&F.log==2?ly:Jp)),v.font=Hp(v.font),v.labelFont=Hp(v.labelFont),v._size=v.size(i,null,E,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Gi[E]=!0,v._el=yi(X_,h))}}function ls(v,E,N,F){let[W,Q,ct,pt]=N,Mt=E%2,Dt=0;return Mt==0&&(pt||Q)&&(Dt=E==0&&!W||E==2&&!ct?gn(Ip.size/3):0),Mt==1&&(W||ct)&&(Dt=E==1&&!Q||E==3&&!pt?gn(Np.size/2):0),Dt}let Fo=i.padding=(n.padding||[ls,ls,ls,ls]).map(v=>xe(be(v,ls))),wi=i._padding=Fo.map((v,E)=>v(i,E,Gi,0)),je,en=null,nn=null,Hi=s==1?y[0].idxs:null,ii=null,As=!1;function Oo(v,E){if(t=v??[],i.data=i._data=t,s==2){je=0;for(let N=1;N<y.length;N++)je+=t[N][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ii=t[0],je=ii.length;let N=t;if(U==2){N=t.slice();let F=N[0]=Array(je);for(let W=0;W<je;W++)F[W]=W}i._data=t=N}if(de(!0),wn("setData"),U==2&&(St=!0),E!==!1){let N=P;N.auto(i,As)?Bo():Ps(M,N.min,N.max),st=st||et.left>=0,mt=!0,Dn()}}i.setData=Oo;function Bo(){As=!0;let v,E;s==1&&(je>0?(en=Hi[0]=0,nn=Hi[1]=je-1,v=t[0][en],E=t[0][nn],U==2?(v=en,E=nn):v==E&&(U==3?[v,E]=xl(v,v,P.log,!1):U==4?[v,E]=yu(v,v,P.log,!1):P.time?E=v+gn(86400/m):[v,E]=ml(v,E,vu,!0))):(en=Hi[0]=v=null,nn=Hi[1]=E=null)),Ps(M,v,E)}let Rr,Cs,Pr,T,G,nt,J,j,Tt,It;function At(v,E,N,F,W,Q){v??=op,N??=Mu,F??="butt",W??=op,Q??="round",v!=Rr&&(d.strokeStyle=Rr=v),W!=Cs&&(d.fillStyle=Cs=W),E!=Pr&&(d.lineWidth=Pr=E),Q!=G&&(d.lineJoin=G=Q),F!=nt&&(d.lineCap=nt=F),N!=T&&d.setLineDash(T=N)}function Lt(v,E,N,F){E!=Cs&&(d.fillStyle=Cs=E),v!=J&&(d.font=J=v),N!=j&&(d.textAlign=j=N),F!=Tt&&(d.textBaseline=Tt=F)}function Vt(v,E,N,F,W=0){if(F.length>0&&v.auto(i,As)&&(E==null||E.min==null)){let Q=be(en,0),ct=be(nn,F.length-1),pt=N.min==null?ax(F,Q,ct,W,v.distr==3):[N.min,N.max];v.min=Pi(v.min,N.min=pt[0]),v.max=Hn(v.max,N.max=pt[1])}}let ee={min:null,max:null};function pe(){for(let F in b){let W=b[F];k[F]==null&&(W.min==null||k[M]!=null&&W.auto(i,As))&&(k[F]=ee)}for(let F in b){let W=b[F];k[F]==null&&W.from!=null&&k[W.from]!=null&&(k[F]=ee)}k[M]!=null&&de(!0);let v={};for(let F in k){let W=k[F];if(W!=null){let Q=v[F]=Yr(b[F],gx);if(W.min!=null)un(Q,W);else if(F!=M||s==2)if(je==0&&Q.from==null){let ct=Q.range(i,null,null,F);Q.min=ct[0],Q.max=ct[1]}else Q.min=Oe,Q.max=-Oe}}if(je>0){y.forEach((F,W)=>{if(s==1){let Q=F.scale,ct=k[Q];if(ct==null)return;let pt=v[Q];if(W==0){let Mt=pt.range(i,pt.min,pt.max,Q);pt.min=Mt[0],pt.max=Mt[1],en=Ri(pt.min,t[0]),nn=Ri(pt.max,t[0]),nn-en>1&&(t[0][en]<pt.min&&en++,t[0][nn]>pt.max&&nn--),F.min=ii[en],F.max=ii[nn]}else F.show&&F.auto&&Vt(pt,ct,F,t[W],F.sorted);F.idxs[0]=en,F.idxs[1]=nn}else if(W>0&&F.show&&F.auto){let[Q,ct]=F.facets,pt=Q.scale,Mt=ct.scale,[Dt,Nt]=t[W],Bt=v[pt],re=v[Mt];Bt!=null&&Vt(Bt,k[pt],Q,Dt,Q.sorted),re!=null&&Vt(re,k[Mt],ct,Nt,ct.sorted),F.min=ct.min,F.max=ct.max}});for(let F in v){let W=v[F],Q=k[F];if(W.from==null&&(Q==null||Q.min==null)){let ct=W.range(i,W.min==Oe?null:W.min,W.max==-Oe?null:W.max,F);W.min=ct[0],W.max=ct[1]}}}for(let F in v){let W=v[F];if(W.from!=null){let Q=v[W.from];if(Q.min==null)W.min=W.max=null;else{let ct=W.range(i,Q.min,Q.max,F);W.min=ct[0],W.max=ct[1]}}}let E={},N=!1;for(let F in v){let W=v[F],Q=b[F];if(Q.min!=W.min||Q.max!=W.max){Q.min=W.min,Q.max=W.max;let ct=Q.distr;Q._min=ct==3?ds(Q.min):ct==4?nu(Q.min,Q.asinh):ct==100?Q.fwd(Q.min):Q.min,Q._max=ct==3?ds(Q.max):ct==4?nu(Q.max,Q.asinh):ct==100?Q.fwd(Q.max):Q.max,E[F]=N=!0}}if(N){y.forEach((F,W)=>{s==2?W>0&&E.y&&(F._paths=null):E[F.scale]&&(F._paths=null)});for(let F in E)St=!0,wn("setScale",F);ft&&et.left>=0&&(st=mt=!0)}for(let F in k)k[F]=null}function zt(v){let E=hu(en-1,0,je-1),N=hu(nn+1,0,je-1);for(;v[E]==null&&E>0;)E--;for(;v[N]==null&&N<je-1;)N++;return[E,N]}function me(){if(je>0){let v=y.some(E=>E._focus)&&It!=kt.alpha;v&&(d.globalAlpha=It=kt.alpha),y.forEach((E,N)=>{if(N>0&&E.show&&(Ze(N,!1),Ze(N,!0),E._paths==null)){let F=It;It!=E.alpha&&(d.globalAlpha=It=E.alpha);let W=s==2?[0,t[N][0].length-1]:zt(t[N]);E._paths=E.paths(i,N,W[0],W[1]),It!=F&&(d.globalAlpha=It=F)}}),y.forEach((E,N)=>{if(N>0&&E.show){let F=It;It!=E.alpha&&(d.globalAlpha=It=E.alpha),E._paths!=null&&Pe(N,!1);{let W=E._paths!=null?E._paths.gaps:null,Q=E.points.show(i,N,en,nn,W),ct=E.points.filter(i,N,Q,W);(Q||ct)&&(E.points._paths=E.points.paths(i,N,en,nn,ct),Pe(N,!0))}It!=F&&(d.globalAlpha=It=F),wn("drawSeries",N)}}),v&&(d.globalAlpha=It=1)}}function Ze(v,E){let N=E?y[v].points:y[v];N._stroke=N.stroke(i,v),N._fill=N.fill(i,v)}function Pe(v,E){let N=E?y[v].points:y[v],{stroke:F,fill:W,clip:Q,flags:ct,_stroke:pt=N._stroke,_fill:Mt=N._fill,_width:Dt=N.width}=N._paths;Dt=Be(Dt*Ee,3);let Nt=null,Bt=Dt%2/2;E&&Mt==null&&(Mt=Dt>0?"#fff":pt);let re=N.pxAlign==1&&Bt>0;if(re&&d.translate(Bt,Bt),!E){let we=L-Dt/2,Me=w-Dt/2,ge=Z+Dt,jt=dt+Dt;Nt=new Path2D,Nt.rect(we,Me,ge,jt)}E?Ut(pt,Dt,N.dash,N.cap,Mt,F,W,ct,Q):Ie(v,pt,Dt,N.dash,N.cap,Mt,F,W,ct,Nt,Q),re&&d.translate(-Bt,-Bt)}function Ie(v,E,N,F,W,Q,ct,pt,Mt,Dt,Nt){let Bt=!1;Mt!=0&&A.forEach((re,we)=>{if(re.series[0]==v){let Me=y[re.series[1]],ge=t[re.series[1]],jt=(Me._paths||ta).band;Ns(jt)&&(jt=re.dir==1?jt[0]:jt[1]);let Xt,We=null;Me.show&&jt&&cx(ge,en,nn)?(We=re.fill(i,we)||Q,Xt=Me._paths.clip):jt=null,Ut(E,N,F,W,We,ct,pt,Mt,Dt,Nt,Xt,jt),Bt=!0}}),Bt||Ut(E,N,F,W,Q,ct,pt,Mt,Dt,Nt)}let mn=$r|fu;function Ut(v,E,N,F,W,Q,ct,pt,Mt,Dt,Nt,Bt){At(v,E,N,F,W),(Mt||Dt||Bt)&&(d.save(),Mt&&d.clip(Mt),Dt&&d.clip(Dt)),Bt?(pt&mn)==mn?(d.clip(Bt),Nt&&d.clip(Nt),_e(W,ct),on(v,Q,E)):pt&fu?(_e(W,ct),d.clip(Bt),on(v,Q,E)):pt&$r&&(d.save(),d.clip(Bt),Nt&&d.clip(Nt),_e(W,ct),d.restore(),on(v,Q,E)):(_e(W,ct),on(v,Q,E)),(Mt||Dt||Bt)&&d.restore()}function on(v,E,N){N>0&&(E instanceof Map?E.forEach((F,W)=>{d.strokeStyle=Rr=W,d.stroke(F)}):E!=null&&v&&d.stroke(E))}function _e(v,E){E instanceof Map?E.forEach((N,F)=>{d.fillStyle=Cs=F,d.fill(N)}):E!=null&&v&&d.fill(E)}function cs(v,E,N,F){let W=C[v],Q;if(F<=0)Q=[0,0];else{let ct=W._space=W.space(i,v,E,N,F),pt=W._incrs=W.incrs(i,v,E,N,F,ct);Q=Py(E,N,pt,F,ct)}return W._found=Q}function an(v,E,N,F,W,Q,ct,pt,Mt,Dt){let Nt=ct%2/2;x==1&&d.translate(Nt,Nt),At(pt,ct,Mt,Dt,pt),d.beginPath();let Bt,re,we,Me,ge=W+(F==0||F==3?-Q:Q);N==0?(re=W,Me=ge):(Bt=W,we=ge);for(let jt=0;jt<v.length;jt++)E[jt]!=null&&(N==0?Bt=we=v[jt]:re=Me=v[jt],d.moveTo(Bt,re),d.lineTo(we,Me));d.stroke(),x==1&&d.translate(-Nt,-Nt)}function Ir(v){let E=!0;return C.forEach((N,F)=>{if(!N.show)return;let W=b[N.scale];if(W.min==null){N._show&&(E=!1,N._show=!1,de(!1));return}else N._show||(E=!1,N._show=!0,de(!1));let Q=N.side,ct=Q%2,{min:pt,max:Mt}=W,[Dt,Nt]=cs(F,pt,Mt,ct==0?V:Rt);if(Nt==0)return;let Bt=W.distr==2,re=N._splits=N.splits(i,F,pt,Mt,Dt,Nt,Bt),we=W.distr==2?re.map(Xt=>ii[Xt]):re,Me=W.distr==2?ii[re[1]]-ii[re[0]]:Dt,ge=N._values=N.values(i,N.filter(i,we,F,Nt,Me),F,Nt,Me);N._rotate=Q==2?N.rotate(i,ge,F,Nt):0;let jt=N._size;N._size=vi(N.size(i,ge,F,v)),jt!=null&&N._size!=jt&&(E=!1)}),E}function Wi(v){let E=!0;return Fo.forEach((N,F)=>{let W=N(i,F,Gi,v);W!=wi[F]&&(E=!1),wi[F]=W}),E}function hs(){for(let v=0;v<C.length;v++){let E=C[v];if(!E.show||!E._show)continue;let N=E.side,F=N%2,W,Q,ct=E.stroke(i,v),pt=N==0||N==3?-1:1,[Mt,Dt]=E._found;if(E.label!=null){let Vn=E.labelGap*pt,oi=gn((E._lpos+Vn)*Ee);Lt(E.labelFont[0],ct,"center",N==2?"top":rp),d.save(),F==1?(W=Q=0,d.translate(oi,gn(w+dt/2)),d.rotate((N==3?-fl:fl)/2)):(W=gn(L+Z/2),Q=oi);let rr=$p(E.label)?E.label(i,v,Mt,Dt):E.label;d.fillText(rr,W,Q),d.restore()}if(Dt==0)continue;let Nt=b[E.scale],Bt=F==0?Z:dt,re=F==0?L:w,we=E._splits,Me=Nt.distr==2?we.map(Vn=>ii[Vn]):we,ge=Nt.distr==2?ii[we[1]]-ii[we[0]]:Mt,jt=E.ticks,Xt=E.border,We=jt.show?jt.size:0,Qe=gn(We*Ee),En=gn((E.alignTo==2?E._size-We-E.gap:E.gap)*Ee),Ue=E._rotate*-fl/180,tn=g(E._pos*Ee),si=(Qe+En)*pt,zn=tn+si;Q=F==0?zn:0,W=F==1?zn:0;let _i=E.font[0],Ei=E.align==1?Gr:E.align==2?Qh:Ue>0?Gr:Ue<0?Qh:F==0?"center":N==3?Qh:Gr,Yi=Ue||F==1?"middle":N==2?"top":rp;Lt(_i,ct,Ei,Yi);let ri=E.font[1]*E.lineGap,xi=we.map(Vn=>g(a(Vn,Nt,Bt,re))),Ti=E._values;for(let Vn=0;Vn<Ti.length;Vn++){let oi=Ti[Vn];if(oi!=null){F==0?W=xi[Vn]:Q=xi[Vn],oi=""+oi;let rr=oi.indexOf(`
`)==-1?[oi]:oi.split(/\n/gm);for(let Gn=0;Gn<rr.length;Gn++){let Af=rr[Gn];Ue?(d.save(),d.translate(W,Q+Gn*ri),d.rotate(Ue),d.fillText(Af,0,0),d.restore()):d.fillText(Af,W,Q+Gn*ri)}}}jt.show&&an(xi,jt.filter(i,Me,v,Dt,ge),F,N,tn,Qe,Be(jt.width*Ee,3),jt.stroke(i,v),jt.dash,jt.cap);let $i=E.grid;$i.show&&an(xi,$i.filter(i,Me,v,Dt,ge),F,F==0?2:1,F==0?w:L,F==0?dt:Z,Be($i.width*Ee,3),$i.stroke(i,v),$i.dash,$i.cap),Xt.show&&an([tn],[1],F==0?1:0,F==0?1:2,F==1?w:L,F==1?dt:Z,Be(Xt.width*Ee,3),Xt.stroke(i,v),Xt.dash,Xt.cap)}wn("drawAxes")}function de(v){y.forEach((E,N)=>{N>0&&(E._paths=null,v&&(s==1?(E.min=null,E.max=null):E.facets.forEach(F=>{F.min=null,F.max=null})))})}let Ke=!1,kn=!1,Le=[];function ln(){kn=!1;for(let v=0;v<Le.length;v++)wn(...Le[v]);Le.length=0}function Dn(){Ke||(bx(cf),Ke=!0)}function il(v,E=!1){Ke=!0,kn=E,v(i),cf(),E&&Le.length>0&&queueMicrotask(ln)}i.batch=il;function cf(){if(lt&&(pe(),lt=!1),St&&(Et(),St=!1),yt){if(Xe(p,Gr,Zt),Xe(p,"top",oe),Xe(p,Jo,V),Xe(p,jo,Rt),Xe(_,Gr,Zt),Xe(_,"top",oe),Xe(_,Jo,V),Xe(_,jo,Rt),Xe(h,Jo,Je),Xe(h,jo,rn),u.width=gn(Je*Ee),u.height=gn(rn*Ee),C.forEach(({_el:v,_show:E,_size:N,_pos:F,side:W})=>{if(v!=null)if(E){let Q=W===3||W===0?N:0,ct=W%2==1;Xe(v,ct?"left":"top",F-Q),Xe(v,ct?"width":"height",N),Xe(v,ct?"top":"left",ct?oe:Zt),Xe(v,ct?"height":"width",ct?Rt:V),lu(v,cr)}else li(v,cr)}),Rr=Cs=Pr=G=nt=J=j=Tt=T=null,It=1,Vo(!0),Zt!=wt||oe!=Fe||V!=Ht||Rt!=Yt){de(!1);let v=V/Ht,E=Rt/Yt;if(ft&&!st&&et.left>=0){et.left*=v,et.top*=E,Lr&&ji(Lr,gn(et.left),0,V,Rt),Dr&&ji(Dr,0,gn(et.top),V,Rt);for(let N=0;N<ue.length;N++){let F=ue[N];F!=null&&(Ve[N]*=v,Bn[N]*=E,ji(F,vi(Ve[N]),vi(Bn[N]),V,Rt))}}if(He.show&&!ot&&He.left>=0&&He.width>0){He.left*=v,He.width*=v,He.top*=E,He.height*=E;for(let N in Vh)Xe(Fr,N,He[N])}wt=Zt,Fe=oe,Ht=V,Yt=Rt}wn("setSize"),yt=!1}Je>0&&rn>0&&(d.clearRect(0,0,u.width,u.height),wn("drawClear"),S.forEach(v=>v()),wn("draw")),He.show&&ot&&(sl(He),ot=!1),ft&&st&&(sr(null,!0,!1),st=!1),ht.show&&ht.live&&mt&&(kh(),mt=!1),l||(l=!0,i.status=1,wn("ready")),As=!1,Ke=!1}i.redraw=(v,E)=>{St=E||!1,v!==!1?Ps(M,P.min,P.max):Dn()};function Fh(v,E){let N=b[v];if(N.from==null){if(je==0){let F=N.range(i,E.min,E.max,v);E.min=F[0],E.max=F[1]}if(E.min>E.max){let F=E.min;E.min=E.max,E.max=F}if(je>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;v==M&&N.distr==2&&je>0&&(E.min=Ri(E.min,t[0]),E.max=Ri(E.max,t[0]),E.min==E.max&&E.max++),k[v]=E,lt=!0,Dn()}}i.setScale=Fh;let Oh,Bh,Lr,Dr,hf,uf,Nr,Ur,df,ff,Ge,$e,Rs=!1,An=et.drag,Mn=An.x,bn=An.y;ft&&(et.x&&(Oh=yi(Y_,_)),et.y&&(Bh=yi($_,_)),P.ori==0?(Lr=Oh,Dr=Bh):(Lr=Bh,Dr=Oh),Ge=et.left,$e=et.top);let He=i.select=un({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Fr=He.show?yi(q_,He.over?_:p):null;function sl(v,E){if(He.show){for(let N in v)He[N]=v[N],N in Vh&&Xe(Fr,N,v[N]);E!==!1&&wn("setSelect")}}i.setSelect=sl;function j0(v){if(y[v].show)$&&lu(qt[v],cr);else if($&&li(qt[v],cr),ft){let N=Ct?ue[0]:ue[v];N!=null&&ji(N,-10,-10,V,Rt)}}function Ps(v,E,N){Fh(v,{min:E,max:N})}function Xi(v,E,N,F){E.focus!=null&&n_(v),E.show!=null&&y.forEach((W,Q)=>{Q>0&&(v==Q||v==null)&&(W.show=E.show,j0(Q),s==2?(Ps(W.facets[0].scale,null,null),Ps(W.facets[1].scale,null,null)):Ps(W.scale,null,null),Dn())}),N!==!1&&wn("setSeries",v,E),F&&Go("setSeries",i,v,E)}i.setSeries=Xi;function K0(v,E){un(A[v],E)}function Q0(v,E){v.fill=xe(v.fill||null),v.dir=be(v.dir,-1),E=E??A.length,A.splice(E,0,v)}function t_(v){v==null?A.length=0:A.splice(v,1)}i.addBand=Q0,i.setBand=K0,i.delBand=t_;function e_(v,E){y[v].alpha=E,ft&&ue[v]!=null&&(ue[v].style.opacity=E),$&&qt[v]&&(qt[v].style.opacity=E)}let us,Is,ir,Or={focus:!0};function n_(v){if(v!=ir){let E=v==null,N=kt.alpha!=1;y.forEach((F,W)=>{if(s==1||W>0){let Q=E||W==0||W==v;F._focus=E?null:Q,N&&e_(W,Q?1:kt.alpha)}}),ir=v,N&&Dn()}}$&&te&&ve(cp,vt,v=>{et._lock||(Qt(v),ir!=null&&Xi(null,Or,!0,cn.setSeries))});function qi(v,E,N){let F=b[E];N&&(v=v/Ee-(F.ori==1?oe:Zt));let W=V;F.ori==1&&(W=Rt,v=W-v),F.dir==-1&&(v=W-v);let Q=F._min,ct=F._max,pt=v/W,Mt=Q+(ct-Q)*pt,Dt=F.distr;return Dt==3?Xr(10,Mt):Dt==4?ux(Mt,F.asinh):Dt==100?F.bwd(Mt):Mt}function i_(v,E){let N=qi(v,M,E);return Ri(N,t[0],en,nn)}i.valToIdx=v=>Ri(v,t[0]),i.posToIdx=i_,i.posToVal=qi,i.valToPos=(v,E,N)=>b[E].ori==0?r(v,b[E],N?Z:V,N?L:0):o(v,b[E],N?dt:Rt,N?w:0),i.setCursor=(v,E,N)=>{Ge=v.left,$e=v.top,sr(null,E,N)};function pf(v,E){Xe(Fr,Gr,He.left=v),Xe(Fr,Jo,He.width=E)}function mf(v,E){Xe(Fr,"top",He.top=v),Xe(Fr,jo,He.height=E)}let ko=P.ori==0?pf:mf,zo=P.ori==1?pf:mf;function s_(){if($&&ht.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&he)continue;let E=ht.values[v],N=0;for(let F in E)Ot[v][N++].firstChild.nodeValue=E[F]}}function kh(v,E){if(v!=null&&(v.idxs?v.idxs.forEach((N,F)=>{tt[F]=N}):mx(v.idx)||tt.fill(v.idx),ht.idx=tt[0]),$&&ht.live){for(let N=0;N<y.length;N++)(N>0||s==1&&!he)&&r_(N,tt[N]);s_()}mt=!1,E!==!1&&wn("setLegend")}i.setLegend=kh;function r_(v,E){let N=y[v],F=v==0&&U==2?ii:t[v],W;he?W=N.values(i,v,E)??Kt:(W=N.value(i,E==null?null:F[E],v,E),W=W==null?Kt:{_:W}),ht.values[v]=W}function sr(v,E,N){df=Ge,ff=$e,[Ge,$e]=et.move(i,Ge,$e),et.left=Ge,et.top=$e,ft&&(Lr&&ji(Lr,gn(Ge),0,V,Rt),Dr&&ji(Dr,0,gn($e),V,Rt));let F,W=en>nn;us=Oe,Is=null;let Q=P.ori==0?V:Rt,ct=P.ori==1?V:Rt;if(Ge<0||je==0||W){F=et.idx=null;for(let pt=0;pt<y.length;pt++){let Mt=ue[pt];Mt!=null&&ji(Mt,-10,-10,V,Rt)}te&&Xi(null,Or,!0,v==null&&cn.setSeries),ht.live&&(tt.fill(F),mt=!0)}else{let pt,Mt,Dt;s==1&&(pt=P.ori==0?Ge:$e,Mt=qi(pt,M),F=et.idx=Ri(Mt,t[0],en,nn),Dt=B(t[0][F],P,Q,0));let Nt=-10,Bt=-10,re=0,we=0,Me=!0,ge="",jt="";for(let Xt=s==2?1:0;Xt<y.length;Xt++){let We=y[Xt],Qe=tt[Xt],En=Qe==null?null:s==1?t[Xt][Qe]:t[Xt][1][Qe],Ue=et.dataIdx(i,Xt,F,Mt),tn=Ue==null?null:s==1?t[Xt][Ue]:t[Xt][1][Ue];if(mt=mt||tn!=En||Ue!=Qe,tt[Xt]=Ue,Xt>0&&We.show){let si=Ue==null?-10:Ue==F?Dt:B(s==1?t[0][Ue]:t[Xt][0][Ue],P,Q,0),zn=tn==null?-10:D(tn,s==1?b[We.scale]:b[We.facets[1].scale],ct,0);if(te&&tn!=null){let _i=P.ori==1?Ge:$e,Ei=_n(kt.dist(i,Xt,Ue,zn,_i));if(Ei<us){let Yi=kt.bias;if(Yi!=0){let ri=qi(_i,We.scale),xi=tn>=0?1:-1,Ti=ri>=0?1:-1;Ti==xi&&(Ti==1?Yi==1?tn>=ri:tn<=ri:Yi==1?tn<=ri:tn>=ri)&&(us=Ei,Is=Xt)}else us=Ei,Is=Xt}}if(mt||Ct){let _i,Ei;P.ori==0?(_i=si,Ei=zn):(_i=zn,Ei=si);let Yi,ri,xi,Ti,$i,Vn,oi=!0,rr=ut.bbox;if(rr!=null){oi=!1;let Gn=rr(i,Xt);xi=Gn.left,Ti=Gn.top,Yi=Gn.width,ri=Gn.height}else xi=_i,Ti=Ei,Yi=ri=ut.size(i,Xt);if(Vn=ut.fill(i,Xt),$i=ut.stroke(i,Xt),Ct)Xt==Is&&us<=kt.prox&&(Nt=xi,Bt=Ti,re=Yi,we=ri,Me=oi,ge=Vn,jt=$i);else{let Gn=ue[Xt];Gn!=null&&(Ve[Xt]=xi,Bn[Xt]=Ti,gp(Gn,Yi,ri,oi),pp(Gn,Vn,$i),ji(Gn,vi(xi),vi(Ti),V,Rt))}}}}if(Ct){let Xt=kt.prox,We=ir==null?us<=Xt:us>Xt||Is!=ir;if(mt||We){let Qe=ue[0];Qe!=null&&(Ve[0]=Nt,Bn[0]=Bt,gp(Qe,re,we,Me),pp(Qe,ge,jt),ji(Qe,vi(Nt),vi(Bt),V,Rt))}}}if(He.show&&Rs)if(v!=null){let[pt,Mt]=cn.scales,[Dt,Nt]=cn.match,[Bt,re]=v.cursor.sync.scales,we=v.cursor.drag;if(Mn=we._x,bn=we._y,Mn||bn){let{left:Me,top:ge,width:jt,height:Xt}=v.select,We=v.scales[Bt].ori,Qe=v.posToVal,En,Ue,tn,si,zn,_i=pt!=null&&Dt(pt,Bt),Ei=Mt!=null&&Nt(Mt,re);_i&&Mn?(We==0?(En=Me,Ue=jt):(En=ge,Ue=Xt),tn=b[pt],si=B(Qe(En,Bt),tn,Q,0),zn=B(Qe(En+Ue,Bt),tn,Q,0),ko(Pi(si,zn),_n(zn-si))):ko(0,Q),Ei&&bn?(We==1?(En=Me,Ue=jt):(En=ge,Ue=Xt),tn=b[Mt],si=D(Qe(En,re),tn,ct,0),zn=D(Qe(En+Ue,re),tn,ct,0),zo(Pi(si,zn),_n(zn-si))):zo(0,ct)}else Gh()}else{let pt=_n(df-hf),Mt=_n(ff-uf);if(P.ori==1){let re=pt;pt=Mt,Mt=re}Mn=An.x&&pt>=An.dist,bn=An.y&&Mt>=An.dist;let Dt=An.uni;Dt!=null?Mn&&bn&&(Mn=pt>=Dt,bn=Mt>=Dt,!Mn&&!bn&&(Mt>pt?bn=!0:Mn=!0)):An.x&&An.y&&(Mn||bn)&&(Mn=bn=!0);let Nt,Bt;Mn&&(P.ori==0?(Nt=Nr,Bt=Ge):(Nt=Ur,Bt=$e),ko(Pi(Nt,Bt),_n(Bt-Nt)),bn||zo(0,ct)),bn&&(P.ori==1?(Nt=Nr,Bt=Ge):(Nt=Ur,Bt=$e),zo(Pi(Nt,Bt),_n(Bt-Nt)),Mn||ko(0,Q)),!Mn&&!bn&&(ko(0,0),zo(0,0))}if(An._x=Mn,An._y=bn,v==null){if(N){if(Tf!=null){let[pt,Mt]=cn.scales;cn.values[0]=pt!=null?qi(P.ori==0?Ge:$e,pt):null,cn.values[1]=Mt!=null?qi(P.ori==1?Ge:$e,Mt):null}Go(tu,i,Ge,$e,V,Rt,F)}if(te){let pt=N&&cn.setSeries,Mt=kt.prox;ir==null?us<=Mt&&Xi(Is,Or,!0,pt):us>Mt?Xi(null,Or,!0,pt):Is!=ir&&Xi(Is,Or,!0,pt)}}mt&&(ht.idx=F,kh()),E!==!1&&wn("setCursor")}let Ls=null;Object.defineProperty(i,"rect",{get(){return Ls==null&&Vo(!1),Ls}});function Vo(v=!1){v?Ls=null:(Ls=_.getBoundingClientRect(),wn("syncRect",Ls))}function gf(v,E,N,F,W,Q,ct){et._lock||Rs&&v!=null&&v.movementX==0&&v.movementY==0||(zh(v,E,N,F,W,Q,ct,!1,v!=null),v!=null?sr(null,!0,!0):sr(E,!0,!1))}function zh(v,E,N,F,W,Q,ct,pt,Mt){if(Ls==null&&Vo(!1),Qt(v),v!=null)N=v.clientX-Ls.left,F=v.clientY-Ls.top;else{if(N<0||F<0){Ge=-10,$e=-10;return}let[Dt,Nt]=cn.scales,Bt=E.cursor.sync,[re,we]=Bt.values,[Me,ge]=Bt.scales,[jt,Xt]=cn.match,We=E.axes[0].side%2==1,Qe=P.ori==0?V:Rt,En=P.ori==1?V:Rt,Ue=We?Q:W,tn=We?W:Q,si=We?F:N,zn=We?N:F;if(Me!=null?N=jt(Dt,Me)?a(re,b[Dt],Qe,0):-10:N=Qe*(si/Ue),ge!=null?F=Xt(Nt,ge)?a(we,b[Nt],En,0):-10:F=En*(zn/tn),P.ori==1){let _i=N;N=F,F=_i}}Mt&&(E==null||E.cursor.event.type==tu)&&((N<=1||N>=V-1)&&(N=ar(N,V)),(F<=1||F>=Rt-1)&&(F=ar(F,Rt))),pt?(hf=N,uf=F,[Nr,Ur]=et.move(i,N,F)):(Ge=N,$e=F)}let Vh={width:0,height:0,left:0,top:0};function Gh(){sl(Vh,!1)}let _f,xf,yf,vf;function Sf(v,E,N,F,W,Q,ct){Rs=!0,Mn=bn=An._x=An._y=!1,zh(v,E,N,F,W,Q,ct,!0,!1),v!=null&&(ve(eu,ou,Mf,!1),Go(ap,i,Nr,Ur,V,Rt,null));let{left:pt,top:Mt,width:Dt,height:Nt}=He;_f=pt,xf=Mt,yf=Dt,vf=Nt}function Mf(v,E,N,F,W,Q,ct){Rs=An._x=An._y=!1,zh(v,E,N,F,W,Q,ct,!1,!0);let{left:pt,top:Mt,width:Dt,height:Nt}=He,Bt=Dt>0||Nt>0,re=_f!=pt||xf!=Mt||yf!=Dt||vf!=Nt;if(Bt&&re&&sl(He),An.setScale&&Bt&&re){let we=pt,Me=Dt,ge=Mt,jt=Nt;if(P.ori==1&&(we=Mt,Me=Nt,ge=pt,jt=Dt),Mn&&Ps(M,qi(we,M),qi(we+Me,M)),bn)for(let Xt in b){let We=b[Xt];Xt!=M&&We.from==null&&We.min!=Oe&&Ps(Xt,qi(ge+jt,Xt),qi(ge,Xt))}Gh()}else et.lock&&(et._lock=!et._lock,sr(E,!0,v!=null));v!=null&&(pn(eu,ou),Go(eu,i,Ge,$e,V,Rt,null))}function o_(v,E,N,F,W,Q,ct){if(et._lock)return;Qt(v);let pt=Rs;if(Rs){let Mt=!0,Dt=!0,Nt=10,Bt,re;P.ori==0?(Bt=Mn,re=bn):(Bt=bn,re=Mn),Bt&&re&&(Mt=Ge<=Nt||Ge>=V-Nt,Dt=$e<=Nt||$e>=Rt-Nt),Bt&&Mt&&(Ge=Ge<Nr?0:V),re&&Dt&&($e=$e<Ur?0:Rt),sr(null,!0,!0),Rs=!1}Ge=-10,$e=-10,tt.fill(null),sr(null,!0,!0),pt&&(Rs=pt)}function bf(v,E,N,F,W,Q,ct){et._lock||(Qt(v),Bo(),Gh(),v!=null&&Go(hp,i,Ge,$e,V,Rt,null))}function wf(){C.forEach(Iy),z(i.width,i.height,!0)}hr(pl,Wr,wf);let Br={};Br.mousedown=Sf,Br.mousemove=gf,Br.mouseup=Mf,Br.dblclick=bf,Br.setSeries=(v,E,N,F)=>{let W=cn.match[2];N=W(i,E,N),N!=-1&&Xi(N,F,!0,!1)},ft&&(ve(ap,_,Sf),ve(tu,_,gf),ve(lp,_,v=>{Qt(v),Vo(!1)}),ve(cp,_,o_),ve(hp,_,bf),pu.add(i),i.syncRect=Vo);let rl=i.hooks=n.hooks||{};function wn(v,E,N){kn?Le.push([v,E,N]):v in rl&&rl[v].forEach(F=>{F.call(null,i,E,N)})}(n.plugins||[]).forEach(v=>{for(let E in v.hooks)rl[E]=(rl[E]||[]).concat(v.hooks[E])});let Ef=(v,E,N)=>N,cn=un({key:null,setSeries:!1,filters:{pub:Sp,sub:Sp},scales:[M,y[1]?y[1].scale:null],match:[Mp,Mp,Ef],values:[null,null]},et.sync);cn.match.length==2&&cn.match.push(Ef),et.sync=cn;let Tf=cn.key,Hh=xm(Tf);function Go(v,E,N,F,W,Q,ct){cn.filters.pub(v,E,N,F,W,Q,ct)&&Hh.pub(v,E,N,F,W,Q,ct)}Hh.sub(i);function a_(v,E,N,F,W,Q,ct){cn.filters.sub(v,E,N,F,W,Q,ct)&&Br[v](null,E,N,F,W,Q,ct)}i.pub=a_;function l_(){Hh.unsub(i),pu.delete(i),Sn.clear(),cu(pl,Wr,wf),c.remove(),vt?.remove(),wn("destroy")}i.destroy=l_;function Wh(){wn("init",n,t),Oo(t||n.data,!1),k[M]?Fh(M,k[M]):Bo(),ot=He.show&&(He.width>0||He.height>0),st=mt=!0,z(n.width,n.height)}return y.forEach(Cr),C.forEach(as),e?e instanceof HTMLElement?(e.appendChild(c),Wh()):e(i,Wh):Wh(),i}Cn.assign=un;Cn.fmtNum=Su;Cn.rangeNum=ml;Cn.rangeLog=xl;Cn.rangeAsinh=yu;Cn.orient=dr;Cn.pxRatio=Ee;Cn.join=Mx;Cn.fmtDate=bu,Cn.tzDate=Dx;Cn.sync=xm;{Cn.addGap=my,Cn.clipGaps=Sl;let n=Cn.paths={points:wm};n.linear=Tm,n.stepped=xy,n.bars=yy,n.spline=Sy}var Ly="robot-dynamics",fr=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim();function Dy(n){let{joints:t,units:e,trajectory:i}=n,{name:s}=n.tip(),r=(l,c,u,d)=>({key:l,title:c,curves:t.map((h,p)=>({joint:p,name:h.name,unit:u(h.type),color:`--joint-${p%8}`,isDashed:p>=8,values:i[l].map(_=>_[p]*(d?e.factor(h.type):1)),now:_=>_[l][p]*(d?e.factor(h.type):1)}))}),o=(l,c,u,d,h,p)=>({joint:null,name:l,sign:c,values:u,unit:d,color:h,now:p}),a=l=>i.tip.map(c=>c[l]);return[r("q",["q","positions"],e.position,!0),r("qd",["q\u0307","velocities"],e.velocity,!0),r("qdd",["q\u0308","accelerations"],e.acceleration,!0),r("tau",["\u03C4","torques and forces"],e.force,!1),{key:"energy",title:["E","energies"],curves:[o("kinetic","T",i.kinetic,"J","--joint-0",({kinetic:l})=>l),o("potential","U",i.potential,"J","--joint-1",({potential:l})=>l),o("total","T+U",i.total,"J","--ink",({kinetic:l,potential:c})=>l+c)]},{key:"tip",title:["p",s],curves:[0,1,2].map(l=>o("xyz"[l],"xyz"[l],a(l),"m",["--axis-x","--axis-y","--axis-z"][l],({tip:c})=>c[l][3]))}]}function Ny(n,t){if(n===null||!Number.isFinite(n+t))return[-1,1];let e=t-n,i=Math.max(Math.abs(n),Math.abs(t));return e<=1e-9*i||e<1e-12?i<1e-12?[-1,1]:[n-.5*i,t+.5*i]:[n-.06*e,t+.06*e]}function Uy(n,t,e,i){let[s,r,o]=["--ink","--line","--muted"].map(fr),a=[...new Set(n.curves.map(({unit:u})=>u))],l="11px system-ui, sans-serif",c=(u,d,h)=>({scale:u,side:d,stroke:o,font:l,size:46,gap:3,grid:{show:h,stroke:r,width:1},ticks:{show:!1},values:(p,_)=>_.map(x=>String(Number(x.toPrecision(6))))});return{width:t,height:e,padding:[8,a.length>1?0:12,0,0],legend:{show:!1},cursor:{sync:{key:Ly},drag:{x:!1,y:!1},points:{size:6},y:!1},focus:{alpha:.3},scales:{x:{time:!1,range:()=>[i[0],i[i.length-1]||1]},...Object.fromEntries(a.map(u=>[u,{range:(d,h,p)=>Ny(h,p)}]))},axes:[{stroke:o,font:l,size:26,gap:3,grid:{stroke:r,width:1},ticks:{show:!1},values:(u,d)=>d.map(h=>`${Number(h.toPrecision(6))}`)},...a.map((u,d)=>c(u,d===0?3:1,d===0))],series:[{},...n.curves.map(({name:u,unit:d,color:h,isDashed:p})=>({label:u,scale:d,stroke:fr(h)||s,width:1.8,dash:p?[5,4]:void 0,points:{show:!1}}))]}}function Pm(n){let{joints:t}=n,e=new Set,i=H("div",{class:"plots"}),s=H("p",{class:"status",role:"status","data-key":"status"}),r=[],o=H("div",{class:"legend",role:"group","aria-label":"Joints in the plots"},t.map((x,g)=>{let m=H("button",{type:"button",class:"chip","aria-pressed":!0});return m.style.setProperty("--color",`var(--joint-${g%8})`),m.append(H("span",{class:"dot"}),x.name),m.addEventListener("click",()=>{e.delete(g)||e.add(g),m.setAttribute("aria-pressed",!e.has(g)),r.forEach(({plot:y,chart:C,readings:b})=>y.curves.forEach(({joint:A},M)=>{A===g&&(C.setSeries(M+1,{show:!e.has(g)}),b[M].hidden=e.has(g))}))}),m})),a=H("button",{type:"button",class:"quiet","data-key":"csv"},"Save as CSV");a.addEventListener("click",()=>{let x=t.map(y=>y.name),g=tp(n.trajectory,x),m=H("a",{href:URL.createObjectURL(new Blob([g],{type:"text/csv"}))});m.download=`${n.table.name}.csv`,m.click(),setTimeout(()=>URL.revokeObjectURL(m.href),1e3)});function l(){let{trajectory:x}=n;if(r.forEach(({chart:m})=>m.destroy()),r=[],i.replaceChildren(),_.hidden=x===null,!x)return;d();let g=x.t.length>1;if(a.disabled=!g,!!g){for(let m of Dy(n)){let[y,C]=m.title,b=[...new Set(m.curves.map(({unit:U})=>U))],A=m.curves.map(({color:U,sign:B,joint:D})=>{let k=H("span",{class:"reading"});return k.style.setProperty("--color",`var(${U})`),k.append(...B?[H("i",{},B)]:ai(y,D+1)," ",H("data")),k}),M=H("div",{class:"chart",role:"img","aria-label":`${C} over time, ${b.join(" and ")}`}),f=H("figure",{"data-plot":m.key},H("figcaption",{},H("b",{},H("i",{},y)),` ${C}, ${b.join(" and ")}`),H("div",{class:"readings"},A),M);i.append(f);let S=168,I=[x.t,...m.curves.map(({values:U})=>U)],R=new Cn(Uy(m,Math.max(M.clientWidth,120),S,x.t),I,M),P=H("div",{class:"playhead"});R.over.append(P),c(R),m.curves.forEach(({joint:U},B)=>{U===null||!e.has(U)||(R.setSeries(B+1,{show:!1}),A[B].hidden=!0)}),r.push({plot:m,chart:R,head:P,readings:A,canvas:M})}p(),u()}}function c(x){let g=m=>{let{left:y}=x.over.getBoundingClientRect();n.play(!1),n.setTime(x.posToVal(m.clientX-y,"x"))};x.over.addEventListener("pointerdown",m=>{x.over.setPointerCapture(m.pointerId),g(m)}),x.over.addEventListener("pointermove",m=>{x.over.hasPointerCapture(m.pointerId)&&g(m)})}function u(){let{trajectory:x,state:g}=n;if(!x||r.length===0)return;let m=n.evaluated();for(let{plot:y,chart:C,head:b,readings:A}of r)b.style.transform=`translateX(${C.valToPos(g.t,"x")}px)`,y.curves.forEach(({now:M},f)=>{let S=A[f].lastChild;S.value=String(M(m)),S.textContent=Ho(M(m))})}function d(){let{trajectory:x,state:g,table:m}=n,y=[],C=x.t.length>1;if(x.ended){let{t:b,reason:A}=x.ended;y.push(C?`Ends at ${Ho(b)} s: ${A}.`:`The motion cannot begin: ${A}.`)}if(g.mode==="free"&&C){let b=x.energyScale>0?x.drift/x.energyScale:0;y.push(`Integrated by DOP853. Energy and work balance to ${x.drift.toExponential(1)} J, ${b.toExponential(1)} of what is exchanged.`);let A=t.filter((M,f)=>{let{limits:S}=m.rows.find(I=>I.joint===f);return S&&x.q.some(I=>I[f]<S[0]-1e-9||I[f]>S[1]+1e-9)});A.length>0&&y.push(`Limits are no stops here: ${A.map(M=>M.name).join(", ")} passed them.`)}s.textContent=y.join(" "),s.classList.toggle("warning",!!x.ended)}let h=new ResizeObserver(()=>{for(let{chart:x,canvas:g}of r){let m=g.clientWidth;m>0&&m!==x.width&&x.setSize({width:m,height:x.height})}u()}),p=()=>r.forEach(({canvas:x})=>h.observe(x)),_=H("section",{class:"panel","aria-label":"Plots"},H("div",{class:"bar"},o,a),s,i);return n.on("trajectory units theme",()=>_.isConnected&&l()),n.on("time",u),{section:_,build:l}}var $s={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Zs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},lg=0,rd=1,cg=2;var ka=1,hg=2,Eo=3,Js=0,jn=1,es=2,vr=0,To=1,od=2,ad=3,ld=4,ug=5;var Sr=100,dg=101,fg=102,pg=103,mg=104,gg=200,_g=201,xg=202,yg=203,cd=204,hd=205,vg=206,Sg=207,Mg=208,bg=209,wg=210,Eg=211,Tg=212,Ag=213,Cg=214,Jl=0,jl=1,Kl=2,mo=3,Ql=4,tc=5,ec=6,nc=7,ud=0,Rg=1,Pg=2,ns=0,dd=1,fd=2,pd=3,md=4,gd=5,_d=6,xd=7;var yd=300,Mr=301,Ao=302,Dc=303,Nc=304,ic=1e3,Qi=1001,sc=1002,fn=1003,Ig=1004;var za=1005;var $n=1006,Uc=1007;var bs=1008;var ei=1009,vd=1010,Sd=1011,Co=1012,Fc=1013,Bi=1014,ki=1015,zi=1016,Oc=1017,Bc=1018,br=1020,Md=35902,bd=35899,wd=1021,Ed=1022,Vi=1023,vs=1026,ws=1027,Td=1028,kc=1029,js=1030,zc=1031;var Vc=1033,Va=33776,Ga=33777,Ha=33778,Wa=33779,Gc=35840,Hc=35841,Wc=35842,Xc=35843,qc=36196,Yc=37492,$c=37496,Zc=37488,Jc=37489,Xa=37490,jc=37491,Kc=37808,Qc=37809,th=37810,eh=37811,nh=37812,ih=37813,sh=37814,rh=37815,oh=37816,ah=37817,lh=37818,ch=37819,hh=37820,uh=37821,dh=36492,fh=36494,ph=36495,mh=36283,gh=36284,qa=36285,_h=36286;var ha=2300,rc=2301,$l=2302,Ku=2303,Qu=2400,td=2401,ed=2402;var Lg=3200;var xh=0,Dg=1,Es="",Xn="srgb",ua="srgb-linear",da="linear",Ce="srgb";var Zl=7680;var Ng=519,Ug=512,Fg=513,Og=514,Ad=515,Bg=516,kg=517,Cd=518,Rd=519,Pd=35044;var Id="300 es",Mi=2e3,go=2001;function Fy(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Oy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function fa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function zg(){let n=fa("canvas");return n.style.display="block",n}var Im={},_o=null;function pa(...n){let t="THREE."+n.shift();_o?_o("log",t,...n):console.log(t,...n)}function Vg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $t(...n){n=Vg(n);let t="THREE."+n.shift();if(_o)_o("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ie(...n){n=Vg(n);let t="THREE."+n.shift();if(_o)_o("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function aa(...n){let t=n.join(" ");t in Im||(Im[t]=!0,$t(...n))}function Gg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Hg={[Jl]:Jl,[Kl]:ec,[Ql]:Ql,[mo]:tc,[jl]:jl,[ec]:Kl,[nc]:nc,[tc]:mo},Ui=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Nn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Lm=1234567,la=Math.PI/180,xo=180/Math.PI;function Ks(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Nn[n&255]+Nn[n>>8&255]+Nn[n>>16&255]+Nn[n>>24&255]+"-"+Nn[t&255]+Nn[t>>8&255]+"-"+Nn[t>>16&15|64]+Nn[t>>24&255]+"-"+Nn[e&63|128]+Nn[e>>8&255]+"-"+Nn[e>>16&255]+Nn[e>>24&255]+Nn[i&255]+Nn[i>>8&255]+Nn[i>>16&255]+Nn[i>>24&255]).toLowerCase()}function ae(n,t,e){return Math.max(t,Math.min(e,n))}function Ld(n,t){return(n%t+t)%t}function By(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function ky(n,t,e){return n!==t?(e-n)/(t-n):0}function ca(n,t,e){return(1-e)*n+e*t}function zy(n,t,e,i){return ca(n,t,1-Math.exp(-e*i))}function Vy(n,t=1){return t-Math.abs(Ld(n,t*2)-t)}function Gy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Hy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Wy(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Xy(n,t){return n+Math.random()*(t-n)}function qy(n){return n*(.5-Math.random())}function Yy(n){n!==void 0&&(Lm=n);let t=Lm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function $y(n){return n*la}function Zy(n){return n*xo}function Jy(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function jy(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Dd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ky(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),d=r((t-i)/2),h=o((t-i)/2),p=r((i-t)/2),_=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*_,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*_,a*c);break;case"ZYZ":n.set(l*_,l*p,a*u,a*c);break;default:$t("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function yh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Nd(n,t){if(t.constructor===Float32Array)return n;let e=yh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Ud(n,t){if(t.constructor===Float32Array)return n;let e=yh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Ya={DEG2RAD:la,RAD2DEG:xo,generateUUID:Ks,clamp:ae,euclideanModulo:Ld,mapLinear:By,inverseLerp:ky,lerp:ca,damp:zy,pingpong:Vy,smoothstep:Gy,smootherstep:Hy,randInt:Wy,randFloat:Xy,randFloatSpread:qy,seededRandom:Yy,degToRad:$y,radToDeg:Zy,isPowerOfTwo:Jy,ceilPowerOfTwo:jy,floorPowerOfTwo:Dd,setQuaternionFromProperEuler:Ky,normalize:Ud,denormalize:Nd},zd=class zd{constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};zd.prototype.isVector2=!0;var Jt=zd,Zn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],p=r[o+1],_=r[o+2],x=r[o+3];if(d!==x||l!==h||c!==p||u!==_){let g=l*h+c*p+u*_+d*x;g<0&&(h=-h,p=-p,_=-_,x=-x,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),C=Math.sin(y);m=Math.sin(m*y)/C,a=Math.sin(a*y)/C,l=l*m+h*a,c=c*m+p*a,u=u*m+_*a,d=d*m+x*a}else{l=l*m+h*a,c=c*m+p*a,u=u*m+_*a,d=d*m+x*a;let y=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=y,c*=y,u*=y,d*=y}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],p=r[o+2],_=r[o+3];return t[e]=a*_+u*d+l*p-c*h,t[e+1]=l*_+u*h+c*d-a*p,t[e+2]=c*_+u*p+a*h-l*d,t[e+3]=u*_-a*d-l*h-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),p=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*p*_,this._y=c*p*d-h*u*_,this._z=c*u*_+h*p*d,this._w=c*u*d-h*p*_;break;case"YXZ":this._x=h*u*d+c*p*_,this._y=c*p*d-h*u*_,this._z=c*u*_-h*p*d,this._w=c*u*d+h*p*_;break;case"ZXY":this._x=h*u*d-c*p*_,this._y=c*p*d+h*u*_,this._z=c*u*_+h*p*d,this._w=c*u*d-h*p*_;break;case"ZYX":this._x=h*u*d-c*p*_,this._y=c*p*d+h*u*_,this._z=c*u*_-h*p*d,this._w=c*u*d+h*p*_;break;case"YZX":this._x=h*u*d+c*p*_,this._y=c*p*d+h*u*_,this._z=c*u*_-h*p*d,this._w=c*u*d-h*p*_;break;case"XZY":this._x=h*u*d-c*p*_,this._y=c*p*d-h*u*_,this._z=c*u*_+h*p*d,this._w=c*u*d+h*p*_;break;default:$t("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],d=e[10],h=i+a+d;if(h>0){let p=.5/Math.sqrt(h+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>d){let p=2*Math.sqrt(1+i-a-d);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>d){let p=2*Math.sqrt(1+a-i-d);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+d-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ae(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Vd=class Vd{constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Dm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Dm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this.z=ae(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this.z=ae(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Pu.copy(this).projectOnVector(t),this.sub(Pu)}reflect(t){return this.sub(Pu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};Vd.prototype.isVector3=!0;var X=Vd,Pu=new X,Dm=new Zn,Gd=class Gd{constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],p=i[5],_=i[8],x=s[0],g=s[3],m=s[6],y=s[1],C=s[4],b=s[7],A=s[2],M=s[5],f=s[8];return r[0]=o*x+a*y+l*A,r[3]=o*g+a*C+l*M,r[6]=o*m+a*b+l*f,r[1]=c*x+u*y+d*A,r[4]=c*g+u*C+d*M,r[7]=c*m+u*b+d*f,r[2]=h*x+p*y+_*A,r[5]=h*g+p*C+_*M,r[8]=h*m+p*b+_*f,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=u*o-a*c,h=a*l-u*r,p=c*r-o*l,_=e*d+i*h+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/_;return t[0]=d*x,t[1]=(s*c-u*i)*x,t[2]=(a*i-s*o)*x,t[3]=h*x,t[4]=(u*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=p*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return aa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Iu.makeScale(t,e)),this}rotate(t){return aa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Iu.makeRotation(-t)),this}translate(t,e){return aa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Iu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};Gd.prototype.isMatrix3=!0;var se=Gd,Iu=new se,Nm=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Um=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Qy(){let n={enabled:!0,workingColorSpace:ua,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ce&&(s.r=ys(s.r),s.g=ys(s.g),s.b=ys(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ce&&(s.r=po(s.r),s.g=po(s.g),s.b=po(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?da:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ua]:{primaries:t,whitePoint:i,transfer:da,toXYZ:Nm,fromXYZ:Um,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Xn},outputColorSpaceConfig:{drawingBufferColorSpace:Xn}},[Xn]:{primaries:t,whitePoint:i,transfer:Ce,toXYZ:Nm,fromXYZ:Um,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Xn}}}),n}var ye=Qy();function ys(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function po(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Kr,oc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Kr===void 0&&(Kr=fa("canvas")),Kr.width=t.width,Kr.height=t.height;let s=Kr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Kr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=fa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ys(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ys(e[i]/255)*255):e[i]=ys(e[i]);return{data:e,width:t.width,height:t.height}}else return $t("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},tv=0,yo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:tv++}),this.uuid=Ks(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Lu(s[o].image)):r.push(Lu(s[o]))}else r=Lu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Lu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?oc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($t("Texture: Unable to serialize Texture."),{})}var ev=0,Du=new X,Jn=class n extends Ui{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Qi,s=Qi,r=$n,o=bs,a=Vi,l=ei,c=n.DEFAULT_ANISOTROPY,u=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ev++}),this.uuid=Ks(),this.name="",this.source=new yo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Jt(0,0),this.repeat=new Jt(1,1),this.center=new Jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Du).x}get height(){return this.source.getSize(Du).y}get depth(){return this.source.getSize(Du).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){$t(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==yd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ic:t.x=t.x-Math.floor(t.x);break;case Qi:t.x=t.x<0?0:1;break;case sc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ic:t.y=t.y-Math.floor(t.y);break;case Qi:t.y=t.y<0?0:1;break;case sc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=yd;Jn.DEFAULT_ANISOTROPY=1;var Hd=class Hd{constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],d=l[8],h=l[1],p=l[5],_=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-x)<.01&&Math.abs(_-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+x)<.1&&Math.abs(_+g)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let C=(c+1)/2,b=(p+1)/2,A=(m+1)/2,M=(u+h)/4,f=(d+x)/4,S=(_+g)/4;return C>b&&C>A?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=M/i,r=f/i):b>A?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=M/s,r=S/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=f/r,s=S/r),this.set(i,s,r,e),this}let y=Math.sqrt((g-_)*(g-_)+(d-x)*(d-x)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-_)/y,this.y=(d-x)/y,this.z=(h-u)/y,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this.z=ae(this.z,t.z,e.z),this.w=ae(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this.z=ae(this.z,t,e),this.w=ae(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};Hd.prototype.isVector4=!0;var Re=Hd,ac=class extends Ui{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:$n,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Re(0,0,t,e),this.scissorTest=!1,this.viewport=new Re(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:$n,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new yo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},pi=class extends ac{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ma=class extends Jn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=fn,this.minFilter=fn,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var lc=class extends Jn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=fn,this.minFilter=fn,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Lc=class Lc{constructor(t,e,i,s,r,o,a,l,c,u,d,h,p,_,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,d,h,p,_,x,g)}set(t,e,i,s,r,o,a,l,c,u,d,h,p,_,x,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=d,m[14]=h,m[3]=p,m[7]=_,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Lc().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Qr.setFromMatrixColumn(t,0).length(),r=1/Qr.setFromMatrixColumn(t,1).length(),o=1/Qr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let h=o*u,p=o*d,_=a*u,x=a*d;e[0]=l*u,e[4]=-l*d,e[8]=c,e[1]=p+_*c,e[5]=h-x*c,e[9]=-a*l,e[2]=x-h*c,e[6]=_+p*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*u,p=l*d,_=c*u,x=c*d;e[0]=h+x*a,e[4]=_*a-p,e[8]=o*c,e[1]=o*d,e[5]=o*u,e[9]=-a,e[2]=p*a-_,e[6]=x+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*u,p=l*d,_=c*u,x=c*d;e[0]=h-x*a,e[4]=-o*d,e[8]=_+p*a,e[1]=p+_*a,e[5]=o*u,e[9]=x-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*u,p=o*d,_=a*u,x=a*d;e[0]=l*u,e[4]=_*c-p,e[8]=h*c+x,e[1]=l*d,e[5]=x*c+h,e[9]=p*c-_,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,p=o*c,_=a*l,x=a*c;e[0]=l*u,e[4]=x-h*d,e[8]=_*d+p,e[1]=d,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=p*d+_,e[10]=h-x*d}else if(t.order==="XZY"){let h=o*l,p=o*c,_=a*l,x=a*c;e[0]=l*u,e[4]=-d,e[8]=c*u,e[1]=h*d+x,e[5]=o*u,e[9]=p*d-_,e[2]=_*d-p,e[6]=a*u,e[10]=x*d+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(nv,t,iv)}lookAt(t,e,i){let s=this.elements;return ui.subVectors(t,e),ui.lengthSq()===0&&(ui.z=1),ui.normalize(),Fs.crossVectors(i,ui),Fs.lengthSq()===0&&(Math.abs(i.z)===1?ui.x+=1e-4:ui.z+=1e-4,ui.normalize(),Fs.crossVectors(i,ui)),Fs.normalize(),El.crossVectors(ui,Fs),s[0]=Fs.x,s[4]=El.x,s[8]=ui.x,s[1]=Fs.y,s[5]=El.y,s[9]=ui.y,s[2]=Fs.z,s[6]=El.z,s[10]=ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],p=i[13],_=i[2],x=i[6],g=i[10],m=i[14],y=i[3],C=i[7],b=i[11],A=i[15],M=s[0],f=s[4],S=s[8],I=s[12],R=s[1],P=s[5],U=s[9],B=s[13],D=s[2],k=s[6],q=s[10],O=s[14],it=s[3],Y=s[7],K=s[11],tt=s[15];return r[0]=o*M+a*R+l*D+c*it,r[4]=o*f+a*P+l*k+c*Y,r[8]=o*S+a*U+l*q+c*K,r[12]=o*I+a*B+l*O+c*tt,r[1]=u*M+d*R+h*D+p*it,r[5]=u*f+d*P+h*k+p*Y,r[9]=u*S+d*U+h*q+p*K,r[13]=u*I+d*B+h*O+p*tt,r[2]=_*M+x*R+g*D+m*it,r[6]=_*f+x*P+g*k+m*Y,r[10]=_*S+x*U+g*q+m*K,r[14]=_*I+x*B+g*O+m*tt,r[3]=y*M+C*R+b*D+A*it,r[7]=y*f+C*P+b*k+A*Y,r[11]=y*S+C*U+b*q+A*K,r[15]=y*I+C*B+b*O+A*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],d=t[6],h=t[10],p=t[14],_=t[3],x=t[7],g=t[11],m=t[15],y=l*p-c*h,C=a*p-c*d,b=a*h-l*d,A=o*p-c*u,M=o*h-l*u,f=o*d-a*u;return e*(x*y-g*C+m*b)-i*(_*y-g*A+m*M)+s*(_*C-x*A+m*f)-r*(_*b-x*M+g*f)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=t[9],h=t[10],p=t[11],_=t[12],x=t[13],g=t[14],m=t[15],y=e*a-i*o,C=e*l-s*o,b=e*c-r*o,A=i*l-s*a,M=i*c-r*a,f=s*c-r*l,S=u*x-d*_,I=u*g-h*_,R=u*m-p*_,P=d*g-h*x,U=d*m-p*x,B=h*m-p*g,D=y*B-C*U+b*P+A*R-M*I+f*S;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let k=1/D;return t[0]=(a*B-l*U+c*P)*k,t[1]=(s*U-i*B-r*P)*k,t[2]=(x*f-g*M+m*A)*k,t[3]=(h*M-d*f-p*A)*k,t[4]=(l*R-o*B-c*I)*k,t[5]=(e*B-s*R+r*I)*k,t[6]=(g*b-_*f-m*C)*k,t[7]=(u*f-h*b+p*C)*k,t[8]=(o*U-a*R+c*S)*k,t[9]=(i*R-e*U-r*S)*k,t[10]=(_*M-x*b+m*y)*k,t[11]=(d*b-u*M-p*y)*k,t[12]=(a*I-o*P-l*S)*k,t[13]=(e*P-i*I+s*S)*k,t[14]=(x*C-_*A-g*y)*k,t[15]=(u*A-d*C+h*y)*k,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,d=a+a,h=r*c,p=r*u,_=r*d,x=o*u,g=o*d,m=a*d,y=l*c,C=l*u,b=l*d,A=i.x,M=i.y,f=i.z;return s[0]=(1-(x+m))*A,s[1]=(p+b)*A,s[2]=(_-C)*A,s[3]=0,s[4]=(p-b)*M,s[5]=(1-(h+m))*M,s[6]=(g+y)*M,s[7]=0,s[8]=(_+C)*f,s[9]=(g-y)*f,s[10]=(1-(h+x))*f,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Qr.set(s[0],s[1],s[2]).length(),a=Qr.set(s[4],s[5],s[6]).length(),l=Qr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ii.copy(this);let c=1/o,u=1/a,d=1/l;return Ii.elements[0]*=c,Ii.elements[1]*=c,Ii.elements[2]*=c,Ii.elements[4]*=u,Ii.elements[5]*=u,Ii.elements[6]*=u,Ii.elements[8]*=d,Ii.elements[9]*=d,Ii.elements[10]*=d,e.setFromRotationMatrix(Ii),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Mi,l=!1){let c=this.elements,u=2*r/(e-t),d=2*r/(i-s),h=(e+t)/(e-t),p=(i+s)/(i-s),_,x;if(l)_=r/(o-r),x=o*r/(o-r);else if(a===Mi)_=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===go)_=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Mi,l=!1){let c=this.elements,u=2/(e-t),d=2/(i-s),h=-(e+t)/(e-t),p=-(i+s)/(i-s),_,x;if(l)_=1/(o-r),x=o/(o-r);else if(a===Mi)_=-2/(o-r),x=-(o+r)/(o-r);else if(a===go)_=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}};Lc.prototype.isMatrix4=!0;var De=Lc,Qr=new X,Ii=new De,nv=new X(0,0,0),iv=new X(1,1,1),Fs=new X,El=new X,ui=new X,Fm=new De,Om=new Zn,Ss=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(ae(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ae(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ae(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ae(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ae(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ae(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:$t("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Fm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Fm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Om.setFromEuler(this),this.setFromQuaternion(Om,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ss.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},sv=0,Bm=new X,to=new Zn,ps=new De,Tl=new X,na=new X,rv=new X,ov=new Zn,km=new X(1,0,0),zm=new X(0,1,0),Vm=new X(0,0,1),Gm={type:"added"},av={type:"removed"},eo={type:"childadded",child:null},Nu={type:"childremoved",child:null},Rn=class n extends Ui{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:sv++}),this.uuid=Ks(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new X,e=new Ss,i=new Zn,s=new X(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new De},normalMatrix:{value:new se}}),this.matrix=new De,this.matrixWorld=new De,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.multiply(to),this}rotateOnWorldAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.premultiply(to),this}rotateX(t){return this.rotateOnAxis(km,t)}rotateY(t){return this.rotateOnAxis(zm,t)}rotateZ(t){return this.rotateOnAxis(Vm,t)}translateOnAxis(t,e){return Bm.copy(t).applyQuaternion(this.quaternion),this.position.add(Bm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(km,t)}translateY(t){return this.translateOnAxis(zm,t)}translateZ(t){return this.translateOnAxis(Vm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ps.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Tl.copy(t):Tl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ps.lookAt(na,Tl,this.up):ps.lookAt(Tl,na,this.up),this.quaternion.setFromRotationMatrix(ps),s&&(ps.extractRotation(s.matrixWorld),to.setFromRotationMatrix(ps),this.quaternion.premultiply(to.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Gm),eo.child=t,this.dispatchEvent(eo),eo.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(av),Nu.child=t,this.dispatchEvent(Nu),Nu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ps.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ps.multiply(t.parent.matrixWorld)),t.applyMatrix4(ps),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Gm),eo.child=t,this.dispatchEvent(eo),eo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,t,rv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,ov,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),d=o(t.shapes),h=o(t.skeletons),p=o(t.animations),_=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),p.length>0&&(i.animations=p),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Rn.DEFAULT_UP=new X(0,1,0);Rn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Yn=class extends Rn{constructor(){super(),this.isGroup=!0,this.type="Group"}},lv={type:"move"},vo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Yn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Yn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Yn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,i),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),p=.02,_=.005;c.inputState.pinching&&h>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(lv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Yn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Wg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Os={h:0,s:0,l:0},Al={h:0,s:0,l:0};function Uu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var le=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Xn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=i,ye.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ye.workingColorSpace){if(t=Ld(t,1),e=ae(e,0,1),i=ae(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Uu(o,r,t+1/3),this.g=Uu(o,r,t),this.b=Uu(o,r,t-1/3)}return ye.colorSpaceToWorking(this,s),this}setStyle(t,e=Xn){function i(r){r!==void 0&&parseFloat(r)<1&&$t("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:$t("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);$t("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Xn){let i=Wg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):$t("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ys(t.r),this.g=ys(t.g),this.b=ys(t.b),this}copyLinearToSRGB(t){return this.r=po(t.r),this.g=po(t.g),this.b=po(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Xn){return ye.workingToColorSpace(Un.copy(this),t),Math.round(ae(Un.r*255,0,255))*65536+Math.round(ae(Un.g*255,0,255))*256+Math.round(ae(Un.b*255,0,255))}getHexString(t=Xn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.workingToColorSpace(Un.copy(this),e);let i=Un.r,s=Un.g,r=Un.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ye.workingColorSpace){return ye.workingToColorSpace(Un.copy(this),e),t.r=Un.r,t.g=Un.g,t.b=Un.b,t}getStyle(t=Xn){ye.workingToColorSpace(Un.copy(this),t);let e=Un.r,i=Un.g,s=Un.b;return t!==Xn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Os),this.setHSL(Os.h+t,Os.s+e,Os.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Os),t.getHSL(Al);let i=ca(Os.h,Al.h,e),s=ca(Os.s,Al.s,e),r=ca(Os.l,Al.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Un=new le;le.NAMES=Wg;var _a=class extends Rn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ss,this.environmentIntensity=1,this.environmentRotation=new Ss,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Li=new X,ms=new X,Fu=new X,gs=new X,no=new X,io=new X,Hm=new X,Ou=new X,Bu=new X,ku=new X,zu=new Re,Vu=new Re,Gu=new Re,Vs=class n{constructor(t=new X,e=new X,i=new X){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Li.subVectors(t,e),s.cross(Li);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Li.subVectors(s,e),ms.subVectors(i,e),Fu.subVectors(t,e);let o=Li.dot(Li),a=Li.dot(ms),l=Li.dot(Fu),c=ms.dot(ms),u=ms.dot(Fu),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,p=(c*l-a*u)*h,_=(o*u-a*l)*h;return r.set(1-p-_,_,p)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,gs)===null?!1:gs.x>=0&&gs.y>=0&&gs.x+gs.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,gs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,gs.x),l.addScaledVector(o,gs.y),l.addScaledVector(a,gs.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return zu.setScalar(0),Vu.setScalar(0),Gu.setScalar(0),zu.fromBufferAttribute(t,e),Vu.fromBufferAttribute(t,i),Gu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(zu,r.x),o.addScaledVector(Vu,r.y),o.addScaledVector(Gu,r.z),o}static isFrontFacing(t,e,i,s){return Li.subVectors(i,e),ms.subVectors(t,e),Li.cross(ms).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Li.subVectors(this.c,this.b),ms.subVectors(this.a,this.b),Li.cross(ms).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;no.subVectors(s,i),io.subVectors(r,i),Ou.subVectors(t,i);let l=no.dot(Ou),c=io.dot(Ou);if(l<=0&&c<=0)return e.copy(i);Bu.subVectors(t,s);let u=no.dot(Bu),d=io.dot(Bu);if(u>=0&&d<=u)return e.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(no,o);ku.subVectors(t,r);let p=no.dot(ku),_=io.dot(ku);if(_>=0&&p<=_)return e.copy(r);let x=p*c-l*_;if(x<=0&&c>=0&&_<=0)return a=c/(c-_),e.copy(i).addScaledVector(io,a);let g=u*_-p*d;if(g<=0&&d-u>=0&&p-_>=0)return Hm.subVectors(r,s),a=(d-u)/(d-u+(p-_)),e.copy(s).addScaledVector(Hm,a);let m=1/(g+x+h);return o=x*m,a=h*m,e.copy(i).addScaledVector(no,o).addScaledVector(io,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},mi=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Di.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Di.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Di.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Di):Di.fromBufferAttribute(r,o),Di.applyMatrix4(t.matrixWorld),this.expandByPoint(Di);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Cl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Cl.copy(i.boundingBox)),Cl.applyMatrix4(t.matrixWorld),this.union(Cl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Di),Di.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ia),Rl.subVectors(this.max,ia),so.subVectors(t.a,ia),ro.subVectors(t.b,ia),oo.subVectors(t.c,ia),Bs.subVectors(ro,so),ks.subVectors(oo,ro),pr.subVectors(so,oo);let e=[0,-Bs.z,Bs.y,0,-ks.z,ks.y,0,-pr.z,pr.y,Bs.z,0,-Bs.x,ks.z,0,-ks.x,pr.z,0,-pr.x,-Bs.y,Bs.x,0,-ks.y,ks.x,0,-pr.y,pr.x,0];return!Hu(e,so,ro,oo,Rl)||(e=[1,0,0,0,1,0,0,0,1],!Hu(e,so,ro,oo,Rl))?!1:(Pl.crossVectors(Bs,ks),e=[Pl.x,Pl.y,Pl.z],Hu(e,so,ro,oo,Rl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Di).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Di).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(_s),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},_s=[new X,new X,new X,new X,new X,new X,new X,new X],Di=new X,Cl=new mi,so=new X,ro=new X,oo=new X,Bs=new X,ks=new X,pr=new X,ia=new X,Rl=new X,Pl=new X,mr=new X;function Hu(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){mr.fromArray(n,r);let a=s.x*Math.abs(mr.x)+s.y*Math.abs(mr.y)+s.z*Math.abs(mr.z),l=t.dot(mr),c=e.dot(mr),u=i.dot(mr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var dn=new X,Il=new Jt,cv=0,Ni=class extends Ui{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:cv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Pd,this.updateRanges=[],this.gpuType=ki,this.version=0,this._normalizationScale=t!==void 0?yh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Il.fromBufferAttribute(this,e),Il.applyMatrix3(t),this.setXY(e,Il.x,Il.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.applyMatrix3(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.applyMatrix4(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.applyNormalMatrix(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)dn.fromBufferAttribute(this,e),dn.transformDirection(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Nd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ud(t,this.array)}};var xa=class extends Ni{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ya=class extends Ni{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ze=class extends Ni{constructor(t,e,i){super(new Float32Array(t),e,i)}},hv=new mi,sa=new X,Wu=new X,Fi=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):hv.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;sa.subVectors(t,this.center);let e=sa.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(sa,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Wu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(sa.copy(t.center).add(Wu)),this.expandByPoint(sa.copy(t.center).sub(Wu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},uv=0,Si=new De,Xu=new Rn,ao=new X,di=new mi,ra=new mi,Tn=new X,ti=class n extends Ui{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:uv++}),this.uuid=Ks(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Fy(t)?ya:xa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new se().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Si.makeRotationFromQuaternion(t),this.applyMatrix4(Si),this}rotateX(t){return Si.makeRotationX(t),this.applyMatrix4(Si),this}rotateY(t){return Si.makeRotationY(t),this.applyMatrix4(Si),this}rotateZ(t){return Si.makeRotationZ(t),this.applyMatrix4(Si),this}translate(t,e,i){return Si.makeTranslation(t,e,i),this.applyMatrix4(Si),this}scale(t,e,i){return Si.makeScale(t,e,i),this.applyMatrix4(Si),this}lookAt(t){return Xu.lookAt(t),Xu.updateMatrix(),this.applyMatrix4(Xu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ao).negate(),this.translate(ao.x,ao.y,ao.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ze(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&$t("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new mi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];di.setFromBufferAttribute(r),this.morphTargetsRelative?(Tn.addVectors(this.boundingBox.min,di.min),this.boundingBox.expandByPoint(Tn),Tn.addVectors(this.boundingBox.max,di.max),this.boundingBox.expandByPoint(Tn)):(this.boundingBox.expandByPoint(di.min),this.boundingBox.expandByPoint(di.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let i=this.boundingSphere.center;if(di.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ra.setFromBufferAttribute(a),this.morphTargetsRelative?(Tn.addVectors(di.min,ra.min),di.expandByPoint(Tn),Tn.addVectors(di.max,ra.max),di.expandByPoint(Tn)):(di.expandByPoint(ra.min),di.expandByPoint(ra.max))}di.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Tn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Tn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Tn.fromBufferAttribute(a,c),l&&(ao.fromBufferAttribute(t,c),Tn.add(ao)),s=Math.max(s,i.distanceToSquared(Tn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ni(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new X,l[I]=new X;let u=new X,d=new X,h=new X,p=new Jt,_=new Jt,x=new Jt,g=new X,m=new X;function y(I,R,P){c[I]=c[R]=c[P]=1,u.fromBufferAttribute(i,I),d.fromBufferAttribute(i,R),h.fromBufferAttribute(i,P),p.fromBufferAttribute(r,I),_.fromBufferAttribute(r,R),x.fromBufferAttribute(r,P),d.sub(u),h.sub(u),_.sub(p),x.sub(p);let U=1/(_.x*x.y-x.x*_.y);isFinite(U)&&(g.copy(d).multiplyScalar(x.y).addScaledVector(h,-_.y).multiplyScalar(U),m.copy(h).multiplyScalar(_.x).addScaledVector(d,-x.x).multiplyScalar(U),a[I].add(g),a[R].add(g),a[P].add(g),l[I].add(m),l[R].add(m),l[P].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:t.count}]);for(let I=0,R=C.length;I<R;++I){let P=C[I],U=P.start,B=P.count;for(let D=U,k=U+B;D<k;D+=3)y(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let b=new X,A=new X,M=new X,f=new X;function S(I){M.fromBufferAttribute(s,I),f.copy(M);let R=a[I];b.copy(R),b.sub(M.multiplyScalar(M.dot(R))).normalize(),A.crossVectors(f,R);let U=A.dot(l[I])<0?-1:1;o.setXYZW(I,b.x,b.y,b.z,U)}for(let I=0,R=i.count;I<R;++I)c[I]&&S(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Ni(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,p=i.count;h<p;h++)i.setXYZ(h,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,u=new X,d=new X;if(t)for(let h=0,p=t.count;h<p;h+=3){let _=t.getX(h+0),x=t.getX(h+1),g=t.getX(h+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,p=e.count;h<p;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Tn.fromBufferAttribute(t,e),Tn.normalize(),t.setXYZ(e,Tn.x,Tn.y,Tn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),p=0,_=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*u;for(let m=0;m<u;m++)h[_++]=c[p++]}return new Ni(h,u,d)}if(this.index===null)return $t("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],p=t(h,i);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let p=c[d];u.push(p.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,p=d.length;h<p;h++)u.push(d[h].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},cc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Pd,this.updateRanges=[],this.version=0,this.uuid=Ks()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Wm(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Ks()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Wn=new X,Oi=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?yh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Wn.fromBufferAttribute(this,e),Wn.applyMatrix4(t),this.setXYZ(e,Wn.x,Wn.y,Wn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Wn.fromBufferAttribute(this,e),Wn.applyNormalMatrix(t),this.setXYZ(e,Wn.x,Wn.y,Wn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Wn.fromBufferAttribute(this,e),Wn.transformDirection(t),this.setXYZ(e,Wn.x,Wn.y,Wn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){pa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ni(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){pa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Nd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ud(t,this.data.array)}},qu=new X,dv=new X,fv=new se,fi=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=qu.subVectors(i,e).cross(dv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(qu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||fv.getNormalMatrix(t),s=this.coplanarPoint(qu).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},pv=0,ts=class extends Ui{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:pv++}),this.uuid=Ks(),this.name="",this.type="Material",this.blending=To,this.side=Js,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=cd,this.blendDst=hd,this.blendEquation=Sr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new le(0,0,0),this.blendAlpha=0,this.depthFunc=mo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ng,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Zl,this.stencilZFail=Zl,this.stencilZPass=Zl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){$t(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new le().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new fi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Jt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var xs=new X,Yu=new X,Ll=new X,Dl=new X,xr=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,xs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=xs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(xs.copy(this.origin).addScaledVector(this.direction,e),xs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Yu.copy(t).add(e).multiplyScalar(.5),Ll.copy(e).sub(t).normalize(),Dl.copy(this.origin).sub(Yu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Ll),a=Dl.dot(this.direction),l=-Dl.dot(Ll),c=Dl.lengthSq(),u=Math.abs(1-o*o),d,h,p,_;if(u>0)if(d=o*l-a,h=o*a-l,_=r*u,d>=0)if(h>=-_)if(h<=_){let x=1/u;d*=x,h*=x,p=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),p=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),p=-d*d+h*(h+2*l)+c;else h<=-_?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),p=-d*d+h*(h+2*l)+c):h<=_?(d=0,h=Math.min(Math.max(-r,-l),r),p=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),p=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),p=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Yu).addScaledVector(Ll,h),p}intersectSphere(t,e){if(t.radius<0)return null;xs.subVectors(t.center,this.origin);let i=xs.dot(this.direction),s=xs.dot(xs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),u>=0?(r=(t.min.y-h.y)*u,o=(t.max.y-h.y)*u):(r=(t.max.y-h.y)*u,o=(t.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-h.z)*d,l=(t.max.z-h.z)*d):(a=(t.max.z-h.z)*d,l=(t.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,xs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=t.x-o.x,h=t.y-o.y,p=t.z-o.z,_=e.x-o.x,x=e.y-o.y,g=e.z-o.z,m=i.x-o.x,y=i.y-o.y,C=i.z-o.z,b=Math.abs(l),A=Math.abs(c),M=Math.abs(u),f,S,I,R,P,U,B,D,k,q,O,it;if(b>=A&&b>=M?(I=l,U=d,k=_,it=m,l>=0?(f=c,S=u,R=h,P=p,B=x,D=g,q=y,O=C):(f=u,S=c,R=p,P=h,B=g,D=x,q=C,O=y)):A>=M?(I=c,U=h,k=x,it=y,c>=0?(f=u,S=l,R=p,P=d,B=g,D=_,q=C,O=m):(f=l,S=u,R=d,P=p,B=_,D=g,q=m,O=C)):(I=u,U=p,k=g,it=C,u>=0?(f=l,S=c,R=d,P=h,B=_,D=x,q=m,O=y):(f=c,S=l,R=h,P=d,B=x,D=_,q=y,O=m)),I===0)return null;let Y=f/I,K=S/I,tt=1/I,ht=R-Y*U,et=P-K*U,$=B-Y*k,ft=D-K*k,gt=q-Y*it,vt=O-K*it,_t=gt*ft-vt*$,Ft=ht*vt-et*gt,qt=$*et-ft*ht;if(s){if(_t<0||Ft<0||qt<0)return null}else if((_t<0||Ft<0||qt<0)&&(_t>0||Ft>0||qt>0))return null;let Ot=_t+Ft+qt;if(Ot===0)return null;let ce=tt*(_t*U+Ft*k+qt*it);return(Ot>0?ce<0:ce>0)?null:this.at(ce/Ot,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hc=class extends ts{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new le(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=ud,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Xm=new De,gr=new xr,Nl=new Fi,qm=new X,Ul=new X,Fl=new X,Ol=new X,$u=new X,Bl=new X,Ym=new X,kl=new X,Fn=class extends Rn{constructor(t=new ti,e=new hc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Bl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&($u.fromBufferAttribute(d,t),o?Bl.addScaledVector($u,u):Bl.addScaledVector($u.sub(e),u))}e.add(Bl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Nl.copy(i.boundingSphere),Nl.applyMatrix4(r),gr.copy(t.ray).recast(t.near),!(Nl.containsPoint(gr.origin)===!1&&(gr.intersectSphere(Nl,qm)===null||gr.origin.distanceToSquared(qm)>(t.far-t.near)**2))&&(Xm.copy(r).invert(),gr.copy(t.ray).applyMatrix4(Xm),!(i.boundingBox!==null&&gr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,gr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,x=h.length;_<x;_++){let g=h[_],m=o[g.materialIndex],y=Math.max(g.start,p.start),C=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let b=y,A=C;b<A;b+=3){let M=a.getX(b),f=a.getX(b+1),S=a.getX(b+2);s=zl(this,m,t,i,c,u,d,M,f,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let _=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let g=_,m=x;g<m;g+=3){let y=a.getX(g),C=a.getX(g+1),b=a.getX(g+2);s=zl(this,o,t,i,c,u,d,y,C,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,x=h.length;_<x;_++){let g=h[_],m=o[g.materialIndex],y=Math.max(g.start,p.start),C=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let b=y,A=C;b<A;b+=3){let M=b,f=b+1,S=b+2;s=zl(this,m,t,i,c,u,d,M,f,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let _=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let g=_,m=x;g<m;g+=3){let y=g,C=g+1,b=g+2;s=zl(this,o,t,i,c,u,d,y,C,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function mv(n,t,e,i,s,r,o,a){let l;if(t.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Js,a),l===null)return null;kl.copy(a),kl.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(kl);return c<e.near||c>e.far?null:{distance:c,point:kl.clone(),object:n}}function zl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Ul),n.getVertexPosition(l,Fl),n.getVertexPosition(c,Ol);let u=mv(n,t,e,i,Ul,Fl,Ol,Ym);if(u){let d=new X;Vs.getBarycoord(Ym,Ul,Fl,Ol,d),s&&(u.uv=Vs.getInterpolatedAttribute(s,a,l,c,d,new Jt)),r&&(u.uv1=Vs.getInterpolatedAttribute(r,a,l,c,d,new Jt)),o&&(u.normal=Vs.getInterpolatedAttribute(o,a,l,c,d,new X),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new X,materialIndex:0};Vs.getNormal(Ul,Fl,Ol,h.normal),u.face=h,u.barycoord=d}return u}var uc=class extends Jn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=fn,u=fn,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var _r=new Fi,gv=new Jt(.5,.5),Vl=new X,Gs=class{constructor(t=new fi,e=new fi,i=new fi,s=new fi,r=new fi,o=new fi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Mi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],p=r[7],_=r[8],x=r[9],g=r[10],m=r[11],y=r[12],C=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,p-u,m-_,A-y).normalize(),s[1].setComponents(c+o,p+u,m+_,A+y).normalize(),s[2].setComponents(c+a,p+d,m+x,A+C).normalize(),s[3].setComponents(c-a,p-d,m-x,A-C).normalize(),i)s[4].setComponents(l,h,g,b).normalize(),s[5].setComponents(c-l,p-h,m-g,A-b).normalize();else if(s[4].setComponents(c-l,p-h,m-g,A-b).normalize(),e===Mi)s[5].setComponents(c+l,p+h,m+g,A+b).normalize();else if(e===go)s[5].setComponents(l,h,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),_r.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),_r.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(_r)}intersectsSprite(t){_r.center.set(0,0,0);let e=gv.distanceTo(t.center);return _r.radius=.7071067811865476+e,_r.applyMatrix4(t.matrixWorld),this.intersectsSphere(_r)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Vl.x=s.normal.x>0?t.max.x:t.min.x,Vl.y=s.normal.y>0?t.max.y:t.min.y,Vl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Vl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},$m=new De,dc=class n{constructor(){this.coordinateSystem=Mi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];$m.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Gs),i[s].setFromProjectionMatrix($m,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Gs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var va=class extends ts{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new le(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},fc=new X,pc=new X,Zm=new De,oa=new xr,Gl=new Fi,Zu=new X,Jm=new X,mc=class extends Rn{constructor(t=new ti,e=new va){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)fc.fromBufferAttribute(e,s-1),pc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=fc.distanceTo(pc);t.setAttribute("lineDistance",new ze(i,1))}else $t("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Gl.copy(i.boundingSphere),Gl.applyMatrix4(s),Gl.radius+=r,t.ray.intersectsSphere(Gl)===!1)return;Zm.copy(s).invert(),oa.copy(t.ray).applyMatrix4(Zm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let x=p,g=_-1;x<g;x+=c){let m=u.getX(x),y=u.getX(x+1),C=Hl(this,t,oa,l,m,y,x);C&&e.push(C)}if(this.isLineLoop){let x=u.getX(_-1),g=u.getX(p),m=Hl(this,t,oa,l,x,g,_-1);m&&e.push(m)}}else{let p=Math.max(0,o.start),_=Math.min(h.count,o.start+o.count);for(let x=p,g=_-1;x<g;x+=c){let m=Hl(this,t,oa,l,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=Hl(this,t,oa,l,_-1,p,_-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Hl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(fc.fromBufferAttribute(a,s),pc.fromBufferAttribute(a,r),e.distanceSqToSegment(fc,pc,Zu,Jm)>i)return;Zu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Zu);if(!(c<t.near||c>t.far))return{distance:c,point:Jm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var jm=new X,Km=new X,gc=class extends mc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)jm.fromBufferAttribute(e,s),Km.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+jm.distanceTo(Km);t.setAttribute("lineDistance",new ze(i,1))}else $t("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Sa=class extends Jn{constructor(t=[],e=Mr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ma=class extends Jn{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ms=class extends Jn{constructor(t,e,i=Bi,s,r,o,a=fn,l=fn,c,u=vs,d=1){if(u!==vs&&u!==ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new yo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ba=class extends Ms{constructor(t,e=Bi,i=Mr,s,r,o=fn,a=fn,l,c=vs){let u={width:t,height:t,depth:1},d=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},wa=class extends Jn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Hs=class n extends ti{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,p=0;_("z","y","x",-1,-1,i,e,t,o,r,0),_("z","y","x",1,-1,i,e,-t,o,r,1),_("x","z","y",1,1,t,i,e,s,o,2),_("x","z","y",1,-1,t,i,-e,s,o,3),_("x","y","z",1,-1,t,e,i,s,r,4),_("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ze(c,3)),this.setAttribute("normal",new ze(u,3)),this.setAttribute("uv",new ze(d,2));function _(x,g,m,y,C,b,A,M,f,S,I){let R=b/f,P=A/S,U=b/2,B=A/2,D=M/2,k=f+1,q=S+1,O=0,it=0,Y=new X;for(let K=0;K<q;K++){let tt=K*P-B;for(let ht=0;ht<k;ht++){let et=ht*R-U;Y[x]=et*y,Y[g]=tt*C,Y[m]=D,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[g]=0,Y[m]=M>0?1:-1,u.push(Y.x,Y.y,Y.z),d.push(ht/f),d.push(1-K/S),O+=1}}for(let K=0;K<S;K++)for(let tt=0;tt<f;tt++){let ht=h+tt+k*K,et=h+tt+k*(K+1),$=h+(tt+1)+k*(K+1),ft=h+(tt+1)+k*K;l.push(ht,et,ft),l.push(et,$,ft),it+=6}a.addGroup(p,it,I),p+=it,h+=O}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var So=class n extends ti{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],p=[],_=0,x=[],g=i/2,m=0;y(),o===!1&&(t>0&&C(!0),e>0&&C(!1)),this.setIndex(u),this.setAttribute("position",new ze(d,3)),this.setAttribute("normal",new ze(h,3)),this.setAttribute("uv",new ze(p,2));function y(){let b=new X,A=new X,M=0,f=(e-t)/i;for(let S=0;S<=r;S++){let I=[],R=S/r,P=R*(e-t)+t;for(let U=0;U<=s;U++){let B=U/s,D=B*l+a,k=Math.sin(D),q=Math.cos(D);A.x=P*k,A.y=-R*i+g,A.z=P*q,d.push(A.x,A.y,A.z),b.set(k,f,q).normalize(),h.push(b.x,b.y,b.z),p.push(B,1-R),I.push(_++)}x.push(I)}for(let S=0;S<s;S++)for(let I=0;I<r;I++){let R=x[I][S],P=x[I+1][S],U=x[I+1][S+1],B=x[I][S+1];(t>0||I!==0)&&(u.push(R,P,B),M+=3),(e>0||I!==r-1)&&(u.push(P,U,B),M+=3)}c.addGroup(m,M,0),m+=M}function C(b){let A=_,M=new Jt,f=new X,S=0,I=b===!0?t:e,R=b===!0?1:-1;for(let U=1;U<=s;U++)d.push(0,g*R,0),h.push(0,R,0),p.push(.5,.5),_++;let P=_;for(let U=0;U<=s;U++){let D=U/s*l+a,k=Math.cos(D),q=Math.sin(D);f.x=I*q,f.y=g*R,f.z=I*k,d.push(f.x,f.y,f.z),h.push(0,R,0),M.x=k*.5+.5,M.y=q*.5*R+.5,p.push(M.x,M.y),_++}for(let U=0;U<s;U++){let B=A+U,D=P+U;b===!0?u.push(D,D+1,B):u.push(D+1,D,B),S+=3}c.addGroup(m,S,b===!0?1:2),m+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ea=class n extends So{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var yr=class n extends ti{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=t/a,h=e/l,p=[],_=[],x=[],g=[];for(let m=0;m<u;m++){let y=m*h-o;for(let C=0;C<c;C++){let b=C*d-r;_.push(b,-y,0),x.push(0,0,1),g.push(C/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let C=y+c*m,b=y+c*(m+1),A=y+1+c*(m+1),M=y+1+c*m;p.push(C,b,M),p.push(b,A,M)}this.setIndex(p),this.setAttribute("position",new ze(_,3)),this.setAttribute("normal",new ze(x,3)),this.setAttribute("uv",new ze(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ta=class n extends ti{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],d=new X,h=new X,p=[],_=[],x=[],g=[];for(let m=0;m<=i;m++){let y=[],C=m/i,b=o+C*a,A=t*Math.cos(b),M=Math.sqrt(t*t-A*A),f=0;m===0&&o===0?f=.5/e:m===i&&l===Math.PI&&(f=-.5/e);for(let S=0;S<=e;S++){let I=S/e,R=s+I*r;d.x=-M*Math.cos(R),d.y=A,d.z=M*Math.sin(R),_.push(d.x,d.y,d.z),h.copy(d).normalize(),x.push(h.x,h.y,h.z),g.push(I+f,1-C),y.push(c++)}u.push(y)}for(let m=0;m<i;m++)for(let y=0;y<e;y++){let C=u[m][y+1],b=u[m][y],A=u[m+1][y],M=u[m+1][y+1];(m!==0||o>0)&&p.push(C,b,M),(m!==i-1||l<Math.PI)&&p.push(b,A,M)}this.setIndex(p),this.setAttribute("position",new ze(_,3)),this.setAttribute("normal",new ze(x,3)),this.setAttribute("uv",new ze(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Aa=class extends ti{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],i=new Set,s=new X,r=new X;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let d=l[c],h=d.start,p=d.count;for(let _=h,x=h+p;_<x;_+=3)for(let g=0;g<3;g++){let m=a.getX(_+g),y=a.getX(_+(g+1)%3);s.fromBufferAttribute(o,m),r.fromBufferAttribute(o,y),Qm(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,d=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,d),Qm(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new ze(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Qm(n,t,e){let i=`${n.x},${n.y},${n.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${n.x},${n.y},${n.z}`;return e.has(i)===!0||e.has(s)===!0?!1:(e.add(i),e.add(s),!0)}var Ca=class extends ts{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new le(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function wr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(tg(s))s.isRenderTargetTexture?($t("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(tg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function On(n){let t={};for(let e=0;e<n.length;e++){let i=wr(n[e]);for(let s in i)t[s]=i[s]}return t}function tg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function _v(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Fd(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}var $a={clone:wr,merge:On},xv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,yv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,bi=class extends ts{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=xv,this.fragmentShader=yv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=wr(t.uniforms),this.uniformsGroups=_v(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new le().setHex(s.value);break;case"v2":this.uniforms[i].value=new Jt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Re().fromArray(s.value);break;case"m3":this.uniforms[i].value=new se().fromArray(s.value);break;case"m4":this.uniforms[i].value=new De().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},_c=class extends bi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Mo=class extends ts{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new le(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new le(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=xh,this.normalScale=new Jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var xc=class extends ts{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Lg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},yc=class extends ts{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function lo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Wl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ws=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},vc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Qu,endingEnd:Qu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case td:r=t,a=2*e-i;break;case ed:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case td:o=t,l=2*i-e;break;case ed:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,p=this._weightNext,_=(i-e)/(s-e),x=_*_,g=x*_,m=-h*g+2*h*x-h*_,y=(1+h)*g+(-1.5-2*h)*x+(-.5+h)*_+1,C=(-1-p)*g+(1.5+p)*x+.5*_,b=p*g-p*x;for(let A=0;A!==a;++A)r[A]=m*o[u+A]+y*o[c+A]+C*o[l+A]+b*o[d+A];return r}},Sc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},Mc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},bc=class extends Ws{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let _=(i-e)/(s-e),x=1-_;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*_;return r}let h=a*2,p=t-1;for(let _=0;_!==a;++_){let x=o[c+_],g=o[l+_],m=p*h+_*2,y=d[m],C=d[m+1],b=t*h+_*2,A=u[b],M=u[b+1],f=Sv(i,e,y,A,s);r[_]=Xg(f,x,C,M,g)}return r}};function Xg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function vv(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Sv(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Xg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=vv(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var gi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=lo(e,this.TimeBufferType),this.values=lo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:lo(t.times,Array),values:lo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Wl(t.settings)&&(i.settings={inTangents:lo(t.settings.inTangents,Array),outTangents:lo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Mc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Sc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new vc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new bc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ha:e=this.InterpolantFactoryMethodDiscrete;break;case rc:e=this.InterpolantFactoryMethodLinear;break;case $l:e=this.InterpolantFactoryMethodSmooth;break;case Ku:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $t("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ha;case this.InterpolantFactoryMethodLinear:return rc;case this.InterpolantFactoryMethodSmooth:return $l;case this.InterpolantFactoryMethodBezier:return Ku}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Wl(this.settings)&&(eg(this.settings.inTangents,t),eg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Wl(this.settings)&&(ng(this.settings.inTangents,t),ng(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ie("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ie("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Oy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ie("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===$l,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,h=d-i,p=d+i;for(let _=0;_!==i;++_){let x=e[d+_];if(x!==e[h+_]||x!==e[p+_]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,h=o*i;for(let p=0;p!==i;++p)e[h+p]=e[d+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Wl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function eg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function ng(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=rc;var Xs=class extends gi{constructor(t,e,i){super(t,e,i)}};Xs.prototype.ValueTypeName="bool";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=ha;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var wc=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};wc.prototype.ValueTypeName="color";var Ec=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};Ec.prototype.ValueTypeName="number";var Tc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)Zn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ra=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Tc(this.times,this.values,this.getValueSize(),t)}};Ra.prototype.ValueTypeName="quaternion";Ra.prototype.InterpolantFactoryMethodSmooth=void 0;var qs=class extends gi{constructor(t,e,i){super(t,e,i)}};qs.prototype.ValueTypeName="string";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=ha;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ac=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};Ac.prototype.ValueTypeName="vector";var Cc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let p=c[d],_=c[d+1];if(p.global&&(p.lastIndex=0),p.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},qg=new Cc,Rc=class{constructor(t){this.manager=t!==void 0?t:qg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Rc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Pa=class extends Rn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new le(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ia=class extends Pa{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Rn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new le(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Ju=new De,ig=new X,sg=new X,Pc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Jt(512,512),this.mapType=ei,this.map=null,this.mapPass=null,this.matrix=new De,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gs,this._frameExtents=new Jt(1,1),this._viewportCount=1,this._viewports=[new Re(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;ig.setFromMatrixPosition(t.matrixWorld),e.position.copy(ig),sg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(sg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Ju.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Ju,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===go||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Ju)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Xl=new X,ql=new Zn,Ki=new X,La=class extends Rn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new De,this.projectionMatrix=new De,this.projectionMatrixInverse=new De,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Xl,ql,Ki),Ki.x===1&&Ki.y===1&&Ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Xl,ql,Ki.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Xl,ql,Ki),Ki.x===1&&Ki.y===1&&Ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Xl,ql,Ki.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},zs=new X,rg=new Jt,og=new Jt,qn=class extends La{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=xo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(la*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return xo*2*Math.atan(Math.tan(la*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){zs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(zs.x,zs.y).multiplyScalar(-t/zs.z),zs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(zs.x,zs.y).multiplyScalar(-t/zs.z)}getViewSize(t,e){return this.getViewBounds(t,rg,og),e.subVectors(og,rg)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(la*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Da=class extends La{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},nd=class extends Pc{constructor(){super(new Da(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Na=class extends Pa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Rn.DEFAULT_UP),this.updateMatrix(),this.target=new Rn,this.shadow=new nd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ua=class extends ti{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var co=-90,ho=1,bo=class extends Rn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new qn(co,ho,t,e);s.layers=this.layers,this.add(s);let r=new qn(co,ho,t,e);r.layers=this.layers,this.add(r);let o=new qn(co,ho,t,e);o.layers=this.layers,this.add(o);let a=new qn(co,ho,t,e);a.layers=this.layers,this.add(a);let l=new qn(co,ho,t,e);l.layers=this.layers,this.add(l);let c=new qn(co,ho,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Mi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===go)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=t.getRenderTarget(),h=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(d,h,p),t.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},Ic=class extends qn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Od="\\[\\]\\.:\\/",Mv=new RegExp("["+Od+"]","g"),Bd="[^"+Od+"]",bv="[^"+Od.replace("\\.","")+"]",wv=/((?:WC+[\/:])*)/.source.replace("WC",Bd),Ev=/(WCOD+)?/.source.replace("WCOD",bv),Tv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Bd),Av=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Bd),Cv=new RegExp("^"+wv+Ev+Tv+Av+"$"),Rv=["material","materials","bones","map"],id=class{constructor(t,e,i){let s=i||qe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},qe=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Mv,"")}static parseTrackName(t){let e=Cv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Rv.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){$t("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qe.Composite=id;qe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qe.prototype.GetterByBindingType=[qe.prototype._getValue_direct,qe.prototype._getValue_array,qe.prototype._getValue_arrayElement,qe.prototype._getValue_toArray];qe.prototype.SetterByBindingTypeAndVersioning=[[qe.prototype._setValue_direct,qe.prototype._setValue_direct_setNeedsUpdate,qe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_array,qe.prototype._setValue_array_setNeedsUpdate,qe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_arrayElement,qe.prototype._setValue_arrayElement_setNeedsUpdate,qe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_fromArray,qe.prototype._setValue_fromArray_setNeedsUpdate,qe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var XE=new Float32Array(1);var Ys=class extends cc{constructor(t,e,i=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var wo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ae(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ae(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Wd=class Wd{constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};Wd.prototype.isMatrix2=!0;var sd=Wd;var ag=new X,Yl=new X,uo=new X,fo=new X,ju=new X,Pv=new X,Iv=new X,Fa=class{constructor(t=new X,e=new X){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){ag.subVectors(t,this.start),Yl.subVectors(this.end,this.start);let i=Yl.dot(Yl);if(i===0)return 0;let r=Yl.dot(ag)/i;return e&&(r=ae(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=Pv,i=Iv){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,u=t.end;uo.subVectors(c,a),fo.subVectors(u,l),ju.subVectors(a,l);let d=uo.dot(uo),h=fo.dot(fo),p=fo.dot(ju);if(d<=s&&h<=s)return e.copy(a),i.copy(l),e.distanceToSquared(i);if(d<=s)r=0,o=p/h,o=ae(o,0,1);else{let _=uo.dot(ju);if(h<=s)o=0,r=ae(-_/d,0,1);else{let x=uo.dot(fo),g=d*h-x*x;g!==0?r=ae((x*p-_*h)/g,0,1):r=0,o=(x*r+p)/h,o<0?(o=0,r=ae(-_/d,0,1)):o>1&&(o=1,r=ae((x-_)/d,0,1))}}return e.copy(a).addScaledVector(uo,r),i.copy(l).addScaledVector(fo,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Oa=class extends gc{constructor(t=10,e=10,i=4473924,s=8947848){i=new le(i),s=new le(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let h=0,p=0,_=-a;h<=e;h++,_+=o){l.push(-a,0,_,a,0,_),l.push(_,0,-a,_,0,a);let x=h===r?i:s;x.toArray(c,p),p+=3,x.toArray(c,p),p+=3,x.toArray(c,p),p+=3,x.toArray(c,p),p+=3}let u=new ti;u.setAttribute("position",new ze(l,3)),u.setAttribute("color",new ze(c,3));let d=new va({vertexColors:!0,toneMapped:!1});super(u,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ba=class extends Ui{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function kd(n,t,e,i){let s=Lv(i);switch(e){case wd:return n*t;case Td:return n*t/s.components*s.byteLength;case kc:return n*t/s.components*s.byteLength;case js:return n*t*2/s.components*s.byteLength;case zc:return n*t*2/s.components*s.byteLength;case Ed:return n*t*3/s.components*s.byteLength;case Vi:return n*t*4/s.components*s.byteLength;case Vc:return n*t*4/s.components*s.byteLength;case Va:case Ga:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ha:case Wa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Hc:case Xc:return Math.max(n,16)*Math.max(t,8)/4;case Gc:case Wc:return Math.max(n,8)*Math.max(t,8)/2;case qc:case Yc:case Zc:case Jc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case $c:case Xa:case jc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Kc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Qc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case th:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case eh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case nh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case ih:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case sh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case rh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case oh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case ah:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case lh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case ch:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case hh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case uh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case dh:case fh:case ph:return Math.ceil(n/4)*Math.ceil(t/4)*16;case mh:case gh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case qa:case _h:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Lv(n){switch(n){case ei:case vd:return{byteLength:1,components:1};case Co:case Sd:case zi:return{byteLength:2,components:1};case Oc:case Bc:return{byteLength:2,components:4};case Bi:case Fc:case ki:return{byteLength:4,components:1};case Md:case bd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$t("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function p0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Nv(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((p,_)=>p.start-_.start);let h=0;for(let p=1;p<d.length;p++){let _=d[h],x=d[p];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++h,d[h]=x)}d.length=h+1;for(let p=0,_=d.length;p<_;p++){let x=d[p];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Uv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Fv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Ov=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Bv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,kv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,zv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Vv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Gv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Hv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Wv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Xv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,qv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Yv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,$v=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Zv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Jv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,jv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Kv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Qv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,tS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,eS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,nS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,iS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,sS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,rS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,oS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,aS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,lS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,cS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,hS="gl_FragColor = linearToOutputTexel( gl_FragColor );",uS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,dS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,fS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,pS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,mS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,gS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,_S=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,xS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,yS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,vS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,SS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,MS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,bS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,wS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ES=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,TS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,AS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,CS=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,RS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,PS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,IS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,LS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,DS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,NS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,US=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,FS=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,OS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,BS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,VS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,GS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,HS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,WS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,XS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,qS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,YS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,$S=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,ZS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,JS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,jS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,KS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,QS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,tM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,eM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,nM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,iM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,sM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,rM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,oM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,aM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,lM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,cM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,hM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,uM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,fM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,pM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,mM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,gM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,_M=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,xM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,yM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,vM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,SM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,MM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,bM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,wM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,EM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,TM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,AM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,CM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,RM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,PM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,IM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,LM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,DM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,NM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,UM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,BM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,VM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,GM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,HM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,WM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,XM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,YM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,$M=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,ZM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,JM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,QM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,tb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,eb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,nb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ib=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,rb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ob=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ab=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,lb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,cb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,hb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ub=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,db=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,fb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,fe={alphahash_fragment:Uv,alphahash_pars_fragment:Fv,alphamap_fragment:Ov,alphamap_pars_fragment:Bv,alphatest_fragment:kv,alphatest_pars_fragment:zv,aomap_fragment:Vv,aomap_pars_fragment:Gv,batching_pars_vertex:Hv,batching_vertex:Wv,begin_vertex:Xv,beginnormal_vertex:qv,bsdfs:Yv,iridescence_fragment:$v,bumpmap_pars_fragment:Zv,clipping_planes_fragment:Jv,clipping_planes_pars_fragment:jv,clipping_planes_pars_vertex:Kv,clipping_planes_vertex:Qv,color_fragment:tS,color_pars_fragment:eS,color_pars_vertex:nS,color_vertex:iS,common:sS,defaultnormal_vertex:rS,displacementmap_pars_vertex:oS,displacementmap_vertex:aS,emissivemap_fragment:lS,emissivemap_pars_fragment:cS,colorspace_fragment:hS,colorspace_pars_fragment:uS,envmap_fragment:dS,envmap_common_pars_fragment:fS,envmap_pars_fragment:pS,envmap_pars_vertex:mS,envmap_physical_pars_fragment:TS,envmap_vertex:gS,fog_vertex:_S,fog_pars_vertex:xS,fog_fragment:yS,fog_pars_fragment:vS,gradientmap_pars_fragment:SS,lightmap_pars_fragment:MS,lights_lambert_fragment:bS,lights_lambert_pars_fragment:wS,lights_pars_begin:ES,lights_toon_fragment:AS,lights_toon_pars_fragment:CS,lights_phong_fragment:RS,lights_phong_pars_fragment:PS,lights_physical_fragment:IS,lights_physical_pars_fragment:LS,lights_fragment_begin:DS,lights_fragment_maps:NS,lights_fragment_end:US,lightprobes_pars_fragment:FS,logdepthbuf_fragment:OS,logdepthbuf_pars_fragment:BS,logdepthbuf_pars_vertex:kS,logdepthbuf_vertex:zS,map_fragment:VS,map_pars_fragment:GS,map_particle_fragment:HS,map_particle_pars_fragment:WS,metalnessmap_fragment:XS,metalnessmap_pars_fragment:qS,morphinstance_vertex:YS,morphcolor_vertex:$S,morphnormal_vertex:ZS,morphtarget_pars_vertex:JS,morphtarget_vertex:jS,normal_fragment_begin:KS,normal_fragment_maps:QS,normal_pars_fragment:tM,normal_pars_vertex:eM,normal_vertex:nM,normalmap_pars_fragment:iM,clearcoat_normal_fragment_begin:sM,clearcoat_normal_fragment_maps:rM,clearcoat_pars_fragment:oM,iridescence_pars_fragment:aM,opaque_fragment:lM,packing:cM,premultiplied_alpha_fragment:hM,project_vertex:uM,dithering_fragment:dM,dithering_pars_fragment:fM,roughnessmap_fragment:pM,roughnessmap_pars_fragment:mM,shadowmap_pars_fragment:gM,shadowmap_pars_vertex:_M,shadowmap_vertex:xM,shadowmask_pars_fragment:yM,skinbase_vertex:vM,skinning_pars_vertex:SM,skinning_vertex:MM,skinnormal_vertex:bM,specularmap_fragment:wM,specularmap_pars_fragment:EM,tonemapping_fragment:TM,tonemapping_pars_fragment:AM,transmission_fragment:CM,transmission_pars_fragment:RM,uv_pars_fragment:PM,uv_pars_vertex:IM,uv_vertex:LM,worldpos_vertex:DM,background_vert:NM,background_frag:UM,backgroundCube_vert:FM,backgroundCube_frag:OM,cube_vert:BM,cube_frag:kM,depth_vert:zM,depth_frag:VM,distance_vert:GM,distance_frag:HM,equirect_vert:WM,equirect_frag:XM,linedashed_vert:qM,linedashed_frag:YM,meshbasic_vert:$M,meshbasic_frag:ZM,meshlambert_vert:JM,meshlambert_frag:jM,meshmatcap_vert:KM,meshmatcap_frag:QM,meshnormal_vert:tb,meshnormal_frag:eb,meshphong_vert:nb,meshphong_frag:ib,meshphysical_vert:sb,meshphysical_frag:rb,meshtoon_vert:ob,meshtoon_frag:ab,points_vert:lb,points_frag:cb,shadow_vert:hb,shadow_frag:ub,sprite_vert:db,sprite_frag:fb},Pt={common:{diffuse:{value:new le(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new le(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new le(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new le(16777215)},opacity:{value:1},center:{value:new Jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},Kn={basic:{uniforms:On([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:On([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new le(0)},envMapIntensity:{value:1}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:On([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new le(0)},specular:{value:new le(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:On([Pt.common,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.roughnessmap,Pt.metalnessmap,Pt.fog,Pt.lights,{emissive:{value:new le(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:On([Pt.common,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.gradientmap,Pt.fog,Pt.lights,{emissive:{value:new le(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:On([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:On([Pt.points,Pt.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:On([Pt.common,Pt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:On([Pt.common,Pt.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:On([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:On([Pt.sprite,Pt.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distance:{uniforms:On([Pt.common,Pt.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distance_vert,fragmentShader:fe.distance_frag},shadow:{uniforms:On([Pt.lights,Pt.fog,{color:{value:new le(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};Kn.physical={uniforms:On([Kn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new le(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new le(0)},specularColor:{value:new le(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var vh={r:0,b:0,g:0},pb=new De,m0=new se;m0.set(-1,0,0,0,1,0,0,0,1);function mb(n,t,e,i,s,r){let o=new le(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function p(y){let C=y.isScene===!0?y.background:null;if(C&&C.isTexture){let b=y.backgroundBlurriness>0;C=t.get(C,b)}return C}function _(y){let C=!1,b=p(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),C=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(y,C){let b=p(C);b&&b.isCubeTexture?(c===void 0&&(c=new Fn(new Hs(1,1,1),new bi({name:"BackgroundCubeMaterial",uniforms:wr(Kn.backgroundCube.uniforms),vertexShader:Kn.backgroundCube.vertexShader,fragmentShader:Kn.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,M,f){this.matrixWorld.copyPosition(f.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(pb.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(m0),c.material.toneMapped=ye.getTransfer(b.colorSpace)!==Ce,(u!==b||d!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Fn(new yr(2,2),new bi({name:"BackgroundMaterial",uniforms:wr(Kn.background.uniforms),vertexShader:Kn.background.vertexShader,fragmentShader:Kn.background.fragmentShader,side:Js,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=ye.getTransfer(b.colorSpace)!==Ce,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,C){y.getRGB(vh,Fd(n)),e.buffers.color.setClear(vh.r,vh.g,vh.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,C=1){o.set(y),a=C,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:_,addToRenderList:x,dispose:m}}function gb(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(P,U,B,D,k){let q=!1,O=d(P,D,B,U);r!==O&&(r=O,c(r.object)),q=p(P,D,B,k),q&&_(P,D,B,k),k!==null&&t.update(k,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(P,U,B,D),k!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(k).buffer))}function l(){return n.createVertexArray()}function c(P){return n.bindVertexArray(P)}function u(P){return n.deleteVertexArray(P)}function d(P,U,B,D){let k=D.wireframe===!0,q=i[U.id];q===void 0&&(q={},i[U.id]=q);let O=P.isInstancedMesh===!0?P.id:0,it=q[O];it===void 0&&(it={},q[O]=it);let Y=it[B.id];Y===void 0&&(Y={},it[B.id]=Y);let K=Y[k];return K===void 0&&(K=h(l()),Y[k]=K),K}function h(P){let U=[],B=[],D=[];for(let k=0;k<e;k++)U[k]=0,B[k]=0,D[k]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:B,attributeDivisors:D,object:P,attributes:{},index:null}}function p(P,U,B,D){let k=r.attributes,q=U.attributes,O=0,it=B.getAttributes();for(let Y in it)if(it[Y].location>=0){let tt=k[Y],ht=q[Y];if(ht===void 0&&(Y==="instanceMatrix"&&P.instanceMatrix&&(ht=P.instanceMatrix),Y==="instanceColor"&&P.instanceColor&&(ht=P.instanceColor)),tt===void 0||tt.attribute!==ht||ht&&tt.data!==ht.data)return!0;O++}return r.attributesNum!==O||r.index!==D}function _(P,U,B,D){let k={},q=U.attributes,O=0,it=B.getAttributes();for(let Y in it)if(it[Y].location>=0){let tt=q[Y];tt===void 0&&(Y==="instanceMatrix"&&P.instanceMatrix&&(tt=P.instanceMatrix),Y==="instanceColor"&&P.instanceColor&&(tt=P.instanceColor));let ht={};ht.attribute=tt,tt&&tt.data&&(ht.data=tt.data),k[Y]=ht,O++}r.attributes=k,r.attributesNum=O,r.index=D}function x(){let P=r.newAttributes;for(let U=0,B=P.length;U<B;U++)P[U]=0}function g(P){m(P,0)}function m(P,U){let B=r.newAttributes,D=r.enabledAttributes,k=r.attributeDivisors;B[P]=1,D[P]===0&&(n.enableVertexAttribArray(P),D[P]=1),k[P]!==U&&(n.vertexAttribDivisor(P,U),k[P]=U)}function y(){let P=r.newAttributes,U=r.enabledAttributes;for(let B=0,D=U.length;B<D;B++)U[B]!==P[B]&&(n.disableVertexAttribArray(B),U[B]=0)}function C(P,U,B,D,k,q,O){O===!0?n.vertexAttribIPointer(P,U,B,k,q):n.vertexAttribPointer(P,U,B,D,k,q)}function b(P,U,B,D){x();let k=D.attributes,q=B.getAttributes(),O=U.defaultAttributeValues;for(let it in q){let Y=q[it];if(Y.location>=0){let K=k[it];if(K===void 0&&(it==="instanceMatrix"&&P.instanceMatrix&&(K=P.instanceMatrix),it==="instanceColor"&&P.instanceColor&&(K=P.instanceColor)),K!==void 0){let tt=K.normalized,ht=K.itemSize,et=t.get(K);if(et===void 0)continue;let $=et.buffer,ft=et.type,gt=et.bytesPerElement,vt=ft===n.INT||ft===n.UNSIGNED_INT||K.gpuType===Fc;if(K.isInterleavedBufferAttribute){let _t=K.data,Ft=_t.isInterleavedBuffer===!0?_t.stride:_t.itemSize,qt=K.offset;if(_t.isInstancedInterleavedBuffer||_t.isInstancedBufferAttribute){for(let Ot=0;Ot<Y.locationSize;Ot++)m(Y.location+Ot,_t.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=_t.meshPerAttribute*_t.count)}else for(let Ot=0;Ot<Y.locationSize;Ot++)g(Y.location+Ot);n.bindBuffer(n.ARRAY_BUFFER,$);for(let Ot=0;Ot<Y.locationSize;Ot++)C(Y.location+Ot,ht/Y.locationSize,ft,tt,Ft*gt,(qt+ht/Y.locationSize*Ot)*gt,vt)}else{if(K.isInstancedBufferAttribute){for(let _t=0;_t<Y.locationSize;_t++)m(Y.location+_t,K.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let _t=0;_t<Y.locationSize;_t++)g(Y.location+_t);n.bindBuffer(n.ARRAY_BUFFER,$);for(let _t=0;_t<Y.locationSize;_t++)C(Y.location+_t,ht/Y.locationSize,ft,tt,ht*gt,ht/Y.locationSize*_t*gt,vt)}}else if(O!==void 0){let tt=O[it];if(tt!==void 0)switch(tt.length){case 2:n.vertexAttrib2fv(Y.location,tt);break;case 3:n.vertexAttrib3fv(Y.location,tt);break;case 4:n.vertexAttrib4fv(Y.location,tt);break;default:n.vertexAttrib1fv(Y.location,tt)}}}}y()}function A(){I();for(let P in i){let U=i[P];for(let B in U){let D=U[B];for(let k in D){let q=D[k];for(let O in q)u(q[O].object),delete q[O];delete D[k]}}delete i[P]}}function M(P){if(i[P.id]===void 0)return;let U=i[P.id];for(let B in U){let D=U[B];for(let k in D){let q=D[k];for(let O in q)u(q[O].object),delete q[O];delete D[k]}}delete i[P.id]}function f(P){for(let U in i){let B=i[U];for(let D in B){let k=B[D];if(k[P.id]===void 0)continue;let q=k[P.id];for(let O in q)u(q[O].object),delete q[O];delete k[P.id]}}}function S(P){for(let U in i){let B=i[U],D=P.isInstancedMesh===!0?P.id:0,k=B[D];if(k!==void 0){for(let q in k){let O=k[q];for(let it in O)u(O[it].object),delete O[it];delete k[q]}delete B[D],Object.keys(B).length===0&&delete i[U]}}}function I(){R(),o=!0,r!==s&&(r=s,c(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:R,dispose:A,releaseStatesOfGeometry:M,releaseStatesOfObject:S,releaseStatesOfProgram:f,initAttributes:x,enableAttribute:g,disableUnusedAttributes:y}}function _b(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let p=0;p<u;p++)h+=c[p];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function xb(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let f=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(f.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(f){return!(f!==Vi&&i.convert(f)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(f){let S=f===zi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(f!==ei&&f!==ki&&!S&&i.convert(f)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(f){if(f==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";f="mediump"}return f==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&($t("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&$t("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&$t("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:C,maxFragmentUniforms:b,maxSamples:A,samples:M}}function yb(n){let t=this,e=null,i=0,s=!1,r=!1,o=new fi,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let p=d.length!==0||h||i!==0||s;return s=h,i=d.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){e=u(d,h,0)},this.setState=function(d,h,p){let _=d.clippingPlanes,x=d.clipIntersection,g=d.clipShadows,m=n.get(d);if(!s||_===null||_.length===0||r&&!g)r?u(null):c();else{let y=r?0:i,C=y*4,b=m.clippingState||null;l.value=b,b=u(_,h,C,p);for(let A=0;A!==C;++A)b[A]=e[A];m.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(d,h,p,_){let x=d!==null?d.length:0,g=null;if(x!==0){if(g=l.value,_!==!0||g===null){let m=p+x*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let C=0,b=p;C!==x;++C,b+=4)o.copy(d[C]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var ja=class extends pi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Sa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Hs(5,5,5),r=new bi({name:"CubemapFromEquirect",uniforms:wr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:vr});r.uniforms.tEquirect.value=e;let o=new Fn(s,r),a=e.minFilter;return e.minFilter===bs&&(e.minFilter=$n),new bo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Yg=256,vb=3,Sb=20,g0=256,_0=16,Mb=3,bb=new X,wb=new le,Mh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new bo(1,10,null),this._boxMesh=new Fn(new Hs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=bb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,p=l.autoClearDepth,_=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(wb));let g=new bo(i,s,u);return g.position.copy(a),g.update(l,t),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=p,l.autoClearStencil=_,t.background=x,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Jg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Zg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Yg,Dd(t))}_fromTexture(t,e){t.mapping===Mr||t.mapping===Ao?this._setSize(t.image.length===0?Yg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=$g(t,!1,!1),i=Math.log2(t)-vb;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=$g(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Mr||t.mapping===Ao?(this._cubemapMaterial===null&&(this._cubemapMaterial=Jg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Zg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Eb(),this._integrationMaterial=Tb());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/_0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Mb)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(g0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Ab());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function $g(n,t,e){return new ja(n,{minFilter:bs,generateMipmaps:t,type:zi,colorSpace:ua,depthBuffer:e})}function Ka(n,t,e){return new bi({name:n,uniforms:t,vertexShader:fe.cube_vert,fragmentShader:e,side:jn,blending:vr,depthTest:!1,depthWrite:!1})}function Eb(){return Ka("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${g0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Tb(){return Ka("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:_0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Ab(){return Ka("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Sb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Zg(){return Ka("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Jg(){return Ka("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Cb(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,p=!1){return h==null?null:p?o(h):r(h)}function r(h){if(h&&h.isTexture){let p=h.mapping;if(p===Dc||p===Nc)if(t.has(h)){let _=t.get(h).texture;return a(_,h.mapping)}else{let _=h.image;if(_&&_.height>0){let x=new ja(_.height);return x.fromEquirectangularTexture(n,h),t.set(h,x),h.addEventListener("dispose",c),a(x.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let p=h.mapping,_=p===Dc||p===Nc,x=p===Mr||p===Ao;if(_||x){let g=e.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Mh(n)),g=_?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return _&&y&&y.height>0||x&&y&&l(y)?(i===null&&(i=new Mh(n)),g=_?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,p){return p===Dc?h.mapping=Mr:p===Nc&&(h.mapping=Ao),h}function l(h){let p=0,_=6;for(let x=0;x<_;x++)h[x]!==void 0&&p++;return p===_}function c(h){let p=h.target;p.removeEventListener("dispose",c);let _=t.get(p);_!==void 0&&(t.delete(p),_.dispose())}function u(h){let p=h.target;p.removeEventListener("dispose",u);let _=e.get(p);_!==void 0&&(e.delete(p),_.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function Rb(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&aa("WebGLRenderer: "+i+" extension not supported."),s}}}function Pb(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(_=>delete s[_]);function a(_){l(_.target)}function l(_){_.index!==null&&t.remove(_.index);for(let g in _.attributes)t.remove(_.attributes[g]);_.removeEventListener("dispose",a),delete s[_.id],o.unregister(_);let x=r.get(_);x&&(t.remove(x),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,e.memory.geometries--}function c(_,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function u(_){let x=_.attributes;for(let g in x)t.update(x[g],n.ARRAY_BUFFER)}function d(_){let x=_.index,g=_.attributes.position,m=0;if(g===void 0)return;let y=x!==null?x.array.length:g.array.length/3-1,C=g.count>=65535?ya:xa,b=new C(Math.ceil(y/3)*6,1),A=b.array;if(x!==null){let f=x.array;m=x.version;for(let S=0,I=0;S<y;S+=3){let R=f[S+0],P=f[S+1],U=f[S+2];A[I++]=R,A[I++]=P,A[I++]=P,A[I++]=U,A[I++]=U,A[I++]=R}}else{m=g.version;for(let f=0,S=0;f<y;f+=3){let I=f+0,R=f+1,P=f+2;A[S++]=I,A[S++]=R,A[S++]=R,A[S++]=P,A[S++]=P,A[S++]=I}}b.version=m;let M=r.get(_);M&&t.remove(M),r.set(_,b)}function h(_){let x=r.get(_);if(x){let g=_.index;g!==null&&x.version<g.version&&d(_)}else d(_);return r.get(_)}function p(){for(let _ in s){let x=s[_].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:h,dispose:p}}function Ib(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),e.update(h,i,1)}function c(d,h,p){p!==0&&(n.drawElementsInstanced(i,h,r,d*o,p),e.update(h,i,p))}function u(d,h,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,p);let x=0;for(let g=0;g<p;g++)x+=h[g];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function Lb(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Db(n,t,e){let i=new WeakMap,s=new Re;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let I=function(){f.dispose(),i.delete(a),a.removeEventListener("dispose",I)};h!==void 0&&h.texture.dispose();let p=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],C=0;p===!0&&(C=1),_===!0&&(C=2),x===!0&&(C=3);let b=a.attributes.position.count*C,A=1;b>t.maxTextureSize&&(A=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let M=new Float32Array(b*A*4*d),f=new ma(M,b,A,d);f.type=ki,f.needsUpdate=!0;let S=C*4;for(let R=0;R<d;R++){let P=g[R],U=m[R],B=y[R],D=b*A*4*R;for(let k=0;k<P.count;k++){let q=k*S;p===!0&&(s.fromBufferAttribute(P,k),M[D+q+0]=s.x,M[D+q+1]=s.y,M[D+q+2]=s.z,M[D+q+3]=0),_===!0&&(s.fromBufferAttribute(U,k),M[D+q+4]=s.x,M[D+q+5]=s.y,M[D+q+6]=s.z,M[D+q+7]=0),x===!0&&(s.fromBufferAttribute(B,k),M[D+q+8]=s.x,M[D+q+9]=s.y,M[D+q+10]=s.z,M[D+q+11]=B.itemSize===4?s.w:1)}}h={count:d,texture:f,size:new Jt(b,A)},i.set(a,h),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let _=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function Nb(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=t.get(c,d);if(r.get(h)!==u&&(t.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var Ub={[dd]:"LINEAR_TONE_MAPPING",[fd]:"REINHARD_TONE_MAPPING",[pd]:"CINEON_TONE_MAPPING",[md]:"ACES_FILMIC_TONE_MAPPING",[_d]:"AGX_TONE_MAPPING",[xd]:"NEUTRAL_TONE_MAPPING",[gd]:"CUSTOM_TONE_MAPPING"};function Fb(n,t,e,i,s,r){let o=new pi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new ti;u.setAttribute("position",new ze([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ze([0,2,0,0,2,0],2));let d=new _c({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Fn(u,d),p=new Da(-1,1,1,-1,0,1),_=null,x=null,g=!1,m,y=null,C=[],b=!1;this.setSize=function(A,M){o.setSize(A,M),a!==null&&a.setSize(A,M),l!==null&&l.setSize(A,M);for(let f=0;f<C.length;f++){let S=C[f];S.setSize&&S.setSize(A,M)}},this.setEffects=function(A){C=A,b=C.length>0&&C[0].isRenderPass===!0;let M=o.width,f=o.height;C.length>0&&a===null&&(a=new pi(M,f,{type:zi,depthBuffer:!1,stencilBuffer:!1}),l=new pi(M,f,{type:zi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&C.some(I=>I.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Ms(M,f),r===!0&&(c.format=ws,c.type=br)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let I=0;I<C.length;I++){let R=C[I];R.setSize&&R.setSize(M,f),S&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(A,M){if(g||A.toneMapping===ns&&C.length===0)return!1;if(y=M,M!==null){let f=M.width,S=M.height;(o.width!==f||o.height!==S)&&this.setSize(f,S)}return b===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=ns,!0},this.hasRenderPass=function(){return b},this.end=function(A,M){A.toneMapping=m,g=!0;let f=o,S=a;for(let I=0;I<C.length;I++){let R=C[I];R.enabled!==!1&&(R.render(A,S,f,M),R.needsSwap!==!1&&(f=S,S=S===a?l:a))}if(_!==A.outputColorSpace||x!==A.toneMapping){_=A.outputColorSpace,x=A.toneMapping,d.defines={},ye.getTransfer(_)===Ce&&(d.defines.SRGB_TRANSFER="");let I=Ub[x];I&&(d.defines[I]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=f.texture,A.setRenderTarget(y),A.render(h,p),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var x0=new Jn,y0=new Ms(1,1),v0=new ba(1),S0=new ma,M0=new lc,b0=new Sa,jg=[],Kg=[],Qg=new Float32Array(16),t0=new Float32Array(9),e0=new Float32Array(4);function Po(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=jg[s];if(r===void 0&&(r=new Float32Array(s),jg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function xn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function yn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function wh(n,t){let e=Kg[t];e===void 0&&(e=new Int32Array(t),Kg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function Ob(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Bb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(xn(e,t))return;n.uniform2fv(this.addr,t),yn(e,t)}}function kb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(xn(e,t))return;n.uniform3fv(this.addr,t),yn(e,t)}}function zb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(xn(e,t))return;n.uniform4fv(this.addr,t),yn(e,t)}}function Vb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(xn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),yn(e,t)}else{if(xn(e,i))return;e0.set(i),n.uniformMatrix2fv(this.addr,!1,e0),yn(e,i)}}function Gb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(xn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),yn(e,t)}else{if(xn(e,i))return;t0.set(i),n.uniformMatrix3fv(this.addr,!1,t0),yn(e,i)}}function Hb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(xn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),yn(e,t)}else{if(xn(e,i))return;Qg.set(i),n.uniformMatrix4fv(this.addr,!1,Qg),yn(e,i)}}function Wb(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function Xb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(xn(e,t))return;n.uniform2iv(this.addr,t),yn(e,t)}}function qb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(xn(e,t))return;n.uniform3iv(this.addr,t),yn(e,t)}}function Yb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(xn(e,t))return;n.uniform4iv(this.addr,t),yn(e,t)}}function $b(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Zb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(xn(e,t))return;n.uniform2uiv(this.addr,t),yn(e,t)}}function Jb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(xn(e,t))return;n.uniform3uiv(this.addr,t),yn(e,t)}}function jb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(xn(e,t))return;n.uniform4uiv(this.addr,t),yn(e,t)}}function Eh(n){return n.version===0&&(n.compareFunction=Rd,n.needsUpdate=!0),n}function Kb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Eh(y0):r=x0,e.setTexture2D(t||r,s)}function Qb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||M0,s)}function t1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Eh(v0):r=b0,e.setTextureCube(t||r,s)}function e1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||S0,s)}function n1(n){switch(n){case 5126:return Ob;case 35664:return Bb;case 35665:return kb;case 35666:return zb;case 35674:return Vb;case 35675:return Gb;case 35676:return Hb;case 5124:case 35670:return Wb;case 35667:case 35671:return Xb;case 35668:case 35672:return qb;case 35669:case 35673:return Yb;case 5125:return $b;case 36294:return Zb;case 36295:return Jb;case 36296:return jb;case 35678:case 36198:case 36298:case 36306:case 35682:return Kb;case 35679:case 36299:case 36307:return Qb;case 35680:case 36300:case 36308:case 36293:return t1;case 36289:case 36303:case 36311:case 36292:return e1}}function i1(n,t){n.uniform1fv(this.addr,t)}function s1(n,t){let e=Po(t,this.size,2);n.uniform2fv(this.addr,e)}function r1(n,t){let e=Po(t,this.size,3);n.uniform3fv(this.addr,e)}function o1(n,t){let e=Po(t,this.size,4);n.uniform4fv(this.addr,e)}function a1(n,t){let e=Po(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function l1(n,t){let e=Po(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function c1(n,t){let e=Po(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function h1(n,t){n.uniform1iv(this.addr,t)}function u1(n,t){n.uniform2iv(this.addr,t)}function d1(n,t){n.uniform3iv(this.addr,t)}function f1(n,t){n.uniform4iv(this.addr,t)}function p1(n,t){n.uniform1uiv(this.addr,t)}function m1(n,t){n.uniform2uiv(this.addr,t)}function g1(n,t){n.uniform3uiv(this.addr,t)}function _1(n,t){n.uniform4uiv(this.addr,t)}function x1(n,t,e){let i=this.cache,s=t.length,r=wh(e,s);xn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Eh(y0):o=x0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function y1(n,t,e){let i=this.cache,s=t.length,r=wh(e,s);xn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||M0,r[o])}function v1(n,t,e){let i=this.cache,s=t.length,r=wh(e,s);xn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Eh(v0):o=b0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function S1(n,t,e){let i=this.cache,s=t.length,r=wh(e,s);xn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||S0,r[o])}function M1(n){switch(n){case 5126:return i1;case 35664:return s1;case 35665:return r1;case 35666:return o1;case 35674:return a1;case 35675:return l1;case 35676:return c1;case 5124:case 35670:return h1;case 35667:case 35671:return u1;case 35668:case 35672:return d1;case 35669:case 35673:return f1;case 5125:return p1;case 36294:return m1;case 36295:return g1;case 36296:return _1;case 35678:case 36198:case 36298:case 36306:case 35682:return x1;case 35679:case 36299:case 36307:return y1;case 35680:case 36300:case 36308:case 36293:return v1;case 36289:case 36303:case 36311:case 36292:return S1}}var Yd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=n1(e.type)}},$d=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=M1(e.type)}},Zd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Xd=/(\w+)(\])?(\[|\.)?/g;function n0(n,t){n.seq.push(t),n.map[t.id]=t}function b1(n,t,e){let i=n.name,s=i.length;for(Xd.lastIndex=0;;){let r=Xd.exec(i),o=Xd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){n0(e,c===void 0?new Yd(a,n,t):new $d(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new Zd(a),n0(e,d)),e=d}}}var Ro=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);b1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function i0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var w1=37297,E1=0;function T1(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var s0=new se;function A1(n){ye._getMatrix(s0,ye.workingColorSpace,n);let t=`mat3( ${s0.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(n)){case da:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return $t("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function r0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+T1(n.getShaderSource(t),a)}else return r}function C1(n,t){let e=A1(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var R1={[dd]:"Linear",[fd]:"Reinhard",[pd]:"Cineon",[md]:"ACESFilmic",[_d]:"AgX",[xd]:"Neutral",[gd]:"Custom"};function P1(n,t){let e=R1[t];return e===void 0?($t("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Sh=new X;function I1(){ye.getLuminanceCoefficients(Sh);let n=Sh.x.toFixed(4),t=Sh.y.toFixed(4),e=Sh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function L1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ja).join(`
`)}function D1(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function N1(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ja(n){return n!==""}function o0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function a0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var U1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Jd(n){return n.replace(U1,F1)}function F1(n,t){let e=fe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Jd(e)}var O1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function l0(n){return n.replace(O1,B1)}function B1(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function c0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var k1={[ka]:"SHADOWMAP_TYPE_PCF",[Eo]:"SHADOWMAP_TYPE_VSM"};function z1(n){return k1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var V1={[Ao]:"ENVMAP_MODE_REFRACTION"};function G1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":V1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var H1={[ud]:"ENVMAP_BLENDING_MULTIPLY",[Rg]:"ENVMAP_BLENDING_MIX",[Pg]:"ENVMAP_BLENDING_ADD"};function W1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":H1[n.combine]||"ENVMAP_BLENDING_NONE"}function X1(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=z1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=G1(e),d=W1(e),h=L1(e),p=D1(r),_=s.createProgram(),x,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Ja).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Ja).join(`
`),g.length>0&&(g+=`
`)):(x=[c0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ja).join(`
`),g=[c0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ns?"#define TONE_MAPPING":"",e.toneMapping!==ns?fe.tonemapping_pars_fragment:"",e.toneMapping!==ns?P1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,C1("linearToOutputTexel",e.outputColorSpace),I1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ja).join(`
`)),o=Jd(o),o=o0(o,e),o=a0(o,e),a=Jd(a),a=o0(a,e),a=a0(a,e),o=l0(o),a=l0(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===Id?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Id?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+x+o,C=m+g+a,b=i0(s,s.VERTEX_SHADER,y),A=i0(s,s.FRAGMENT_SHADER,C);s.attachShader(_,b),s.attachShader(_,A),e.index0AttributeName!==void 0?s.bindAttribLocation(_,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function M(R){if(n.debug.checkShaderErrors){let P=s.getProgramInfoLog(_)||"",U=s.getShaderInfoLog(b)||"",B=s.getShaderInfoLog(A)||"",D=P.trim(),k=U.trim(),q=B.trim(),O=!0,it=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,b,A);else{let Y=r0(s,b,"vertex"),K=r0(s,A,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+D+`
`+Y+`
`+K)}else D!==""?$t("WebGLProgram: Program Info Log:",D):(k===""||q==="")&&(it=!1);it&&(R.diagnostics={runnable:O,programLog:D,vertexShader:{log:k,prefix:x},fragmentShader:{log:q,prefix:g}})}s.deleteShader(b),s.deleteShader(A),f=new Ro(s,_),S=N1(s,_)}let f;this.getUniforms=function(){return f===void 0&&M(this),f};let S;this.getAttributes=function(){return S===void 0&&M(this),S};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(_,w1)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=E1++,this.cacheKey=t,this.usedTimes=1,this.program=_,this.vertexShader=b,this.fragmentShader=A,this}var q1=0,jd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Kd(t),e.set(t,i)),i}},Kd=class{constructor(t){this.id=q1++,this.code=t,this.usedTimes=0}};function Y1(n){return n===js||n===Xa||n===qa}function $1(n,t,e,i,s,r){let o=new ga,a=new jd,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(f){return l.add(f),f===0?"uv":`uv${f}`}function _(f,S,I,R,P,U){let B=R.fog,D=P.geometry,k=f.isMeshStandardMaterial||f.isMeshLambertMaterial||f.isMeshPhongMaterial?R.environment:null,q=f.isMeshStandardMaterial||f.isMeshLambertMaterial&&!f.envMap||f.isMeshPhongMaterial&&!f.envMap,O=t.get(f.envMap||k,q),it=h[f.type],Y=i.precision;f.precision!==null&&(Y=i.getMaxPrecision(f.precision),Y!==f.precision&&$t("WebGLProgram.getParameters:",f.precision,"not supported, using",Y,"instead."));let K=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,tt=K!==void 0?K.length:0,ht=0;D.morphAttributes.position!==void 0&&(ht=1),D.morphAttributes.normal!==void 0&&(ht=2),D.morphAttributes.color!==void 0&&(ht=3);let et,$,ft,gt;if(it){let Ct=Kn[it];et=Ct.vertexShader,$=Ct.fragmentShader}else{et=f.vertexShader,$=f.fragmentShader;let Ct=a.getVertexShaderStage(f),ue=a.getFragmentShaderStage(f);a.update(f,Ct,ue),ft=Ct.id,gt=ue.id}let vt=n.getRenderTarget(),_t=n.state.buffers.depth.getReversed(),Ft=P.isInstancedMesh===!0,qt=P.isBatchedMesh===!0,Ot=!!f.map,ce=!!f.matcap,he=!!O,Kt=he&&O.isPMREMTexture===!0,Ye=!!f.aoMap,ke=!!f.lightMap,sn=!!f.bumpMap&&f.wireframe===!1,Ne=!!f.normalMap,Sn=!!f.displacementMap,ve=!!f.emissiveMap,pn=!!f.metalnessMap,Je=!!f.roughnessMap,rn=f.anisotropy>0,V=f.clearcoat>0,Rt=f.diffuseRoughness>0,Zt=f.dispersion>0,oe=f.retroreflectivity>0,wt=f.iridescence>0,Fe=f.sheen>0,Ht=f.transmission>0,Yt=rn&&!!f.anisotropyMap,L=V&&!!f.clearcoatMap,w=V&&!!f.clearcoatNormalMap,Z=V&&!!f.clearcoatRoughnessMap,dt=Rt&&!!f.diffuseRoughnessMap,lt=wt&&!!f.iridescenceMap,yt=wt&&!!f.iridescenceThicknessMap,St=Fe&&!!f.sheenColorMap,st=Fe&&!!f.sheenRoughnessMap,ot=!!f.specularMap,mt=!!f.specularColorMap,z=!!f.specularIntensityMap,at=Ht&&!!f.transmissionMap,rt=Ht&&!!f.thicknessMap,Et=!!f.gradientMap,xt=!!f.alphaMap,bt=f.alphaTest>0,Wt=!!f.alphaHash,Qt=!!f.extensions,ut=ns;f.toneMapped&&(vt===null||vt.isXRRenderTarget===!0)&&(ut=n.toneMapping);let kt=Kt?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,te={shaderID:it,shaderType:f.type,shaderName:f.name,vertexShader:et,fragmentShader:$,defines:f.defines,customVertexShaderID:ft,customFragmentShaderID:gt,isRawShaderMaterial:f.isRawShaderMaterial===!0,glslVersion:f.glslVersion,precision:Y,batching:qt,batchingColor:qt&&P._colorsTexture!==null,instancing:Ft,instancingColor:Ft&&P.instanceColor!==null,instancingMorph:Ft&&P.morphTexture!==null,outputColorSpace:vt===null?n.outputColorSpace:vt.isXRRenderTarget===!0?vt.texture.colorSpace:ye.workingColorSpace,alphaToCoverage:!!f.alphaToCoverage,map:Ot,matcap:ce,envMap:he,envMapMode:he&&O.mapping,envMapPMREM:Kt,envMapMaxLod:Kt?kt.length-1:null,envMapSize:Kt?kt[0].width:null,aoMap:Ye,lightMap:ke,bumpMap:sn,normalMap:Ne,displacementMap:Sn,emissiveMap:ve,normalMapObjectSpace:Ne&&f.normalMapType===Dg,normalMapTangentSpace:Ne&&f.normalMapType===xh,packedNormalMap:Ne&&f.normalMapType===xh&&Y1(f.normalMap.format),metalnessMap:pn,roughnessMap:Je,anisotropy:rn,anisotropyMap:Yt,clearcoat:V,clearcoatMap:L,clearcoatNormalMap:w,clearcoatRoughnessMap:Z,diffuseRoughness:Rt,diffuseRoughnessMap:dt,dispersion:Zt,retroreflection:oe,iridescence:wt,iridescenceMap:lt,iridescenceThicknessMap:yt,sheen:Fe,sheenColorMap:St,sheenRoughnessMap:st,specularMap:ot,specularColorMap:mt,specularIntensityMap:z,transmission:Ht,transmissionMap:at,thicknessMap:rt,gradientMap:Et,opaque:f.transparent===!1&&f.blending===To&&f.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Wt,combine:f.combine,mapUv:Ot&&p(f.map.channel),aoMapUv:Ye&&p(f.aoMap.channel),lightMapUv:ke&&p(f.lightMap.channel),bumpMapUv:sn&&p(f.bumpMap.channel),normalMapUv:Ne&&p(f.normalMap.channel),displacementMapUv:Sn&&p(f.displacementMap.channel),emissiveMapUv:ve&&p(f.emissiveMap.channel),metalnessMapUv:pn&&p(f.metalnessMap.channel),roughnessMapUv:Je&&p(f.roughnessMap.channel),anisotropyMapUv:Yt&&p(f.anisotropyMap.channel),clearcoatMapUv:L&&p(f.clearcoatMap.channel),clearcoatNormalMapUv:w&&p(f.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&p(f.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&p(f.diffuseRoughnessMap.channel),iridescenceMapUv:lt&&p(f.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&p(f.iridescenceThicknessMap.channel),sheenColorMapUv:St&&p(f.sheenColorMap.channel),sheenRoughnessMapUv:st&&p(f.sheenRoughnessMap.channel),specularMapUv:ot&&p(f.specularMap.channel),specularColorMapUv:mt&&p(f.specularColorMap.channel),specularIntensityMapUv:z&&p(f.specularIntensityMap.channel),transmissionMapUv:at&&p(f.transmissionMap.channel),thicknessMapUv:rt&&p(f.thicknessMap.channel),alphaMapUv:xt&&p(f.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ne||rn),vertexNormals:!!D.attributes.normal,vertexColors:f.vertexColors,vertexAlphas:f.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!D.attributes.uv&&(Ot||xt),fog:!!B,useFog:f.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:f.wireframe===!1&&(f.flatShading===!0||D.attributes.normal===void 0&&Ne===!1&&(f.isMeshLambertMaterial||f.isMeshPhongMaterial||f.isMeshStandardMaterial||f.isMeshPhysicalMaterial)),sizeAttenuation:f.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:_t,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:ht,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:U.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:f.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ut,decodeVideoTexture:Ot&&f.map.isVideoTexture===!0&&ye.getTransfer(f.map.colorSpace)===Ce,decodeVideoTextureEmissive:ve&&f.emissiveMap.isVideoTexture===!0&&ye.getTransfer(f.emissiveMap.colorSpace)===Ce,premultipliedAlpha:f.premultipliedAlpha,doubleSided:f.side===es,flipSided:f.side===jn,useDepthPacking:f.depthPacking>=0,depthPacking:f.depthPacking||0,index0AttributeName:f.index0AttributeName,extensionClipCullDistance:Qt&&f.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&f.extensions.multiDraw===!0||qt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:f.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function x(f){let S=[];if(f.shaderID?S.push(f.shaderID):(S.push(f.customVertexShaderID),S.push(f.customFragmentShaderID)),f.defines!==void 0)for(let I in f.defines)S.push(I),S.push(f.defines[I]);return f.isRawShaderMaterial===!1&&(g(S,f),m(S,f),S.push(n.outputColorSpace)),S.push(f.customProgramCacheKey),S.join()}function g(f,S){f.push(S.precision),f.push(S.outputColorSpace),f.push(S.envMapMode),f.push(S.envMapPMREM),f.push(S.envMapMaxLod),f.push(S.envMapSize),f.push(S.mapUv),f.push(S.alphaMapUv),f.push(S.lightMapUv),f.push(S.aoMapUv),f.push(S.bumpMapUv),f.push(S.normalMapUv),f.push(S.displacementMapUv),f.push(S.emissiveMapUv),f.push(S.metalnessMapUv),f.push(S.roughnessMapUv),f.push(S.anisotropyMapUv),f.push(S.clearcoatMapUv),f.push(S.clearcoatNormalMapUv),f.push(S.clearcoatRoughnessMapUv),f.push(S.diffuseRoughnessMapUv),f.push(S.iridescenceMapUv),f.push(S.iridescenceThicknessMapUv),f.push(S.sheenColorMapUv),f.push(S.sheenRoughnessMapUv),f.push(S.specularMapUv),f.push(S.specularColorMapUv),f.push(S.specularIntensityMapUv),f.push(S.transmissionMapUv),f.push(S.thicknessMapUv),f.push(S.combine),f.push(S.fogExp2),f.push(S.sizeAttenuation),f.push(S.morphTargetsCount),f.push(S.numSunLights),f.push(S.numDirLights),f.push(S.numPointLights),f.push(S.numSpotLights),f.push(S.numSpotLightMaps),f.push(S.numHemiLights),f.push(S.numRectAreaLights),f.push(S.numSunLightShadows),f.push(S.numDirLightShadows),f.push(S.numPointLightShadows),f.push(S.numSpotLightShadows),f.push(S.numSpotLightShadowsWithMaps),f.push(S.numLightProbes),f.push(S.numLightProbeGrids),f.push(S.shadowMapType),f.push(S.toneMapping),f.push(S.numClippingPlanes),f.push(S.numClipIntersection),f.push(S.depthPacking)}function m(f,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),f.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),f.push(o.mask)}function y(f){let S=h[f.type],I;if(S){let R=Kn[S];I=$a.clone(R.uniforms)}else I=f.uniforms;return I}function C(f,S){let I=u.get(S);return I!==void 0?++I.usedTimes:(I=new X1(n,S,f,s),c.push(I),u.set(S,I)),I}function b(f){if(--f.usedTimes===0){let S=c.indexOf(f);c[S]=c[c.length-1],c.pop(),u.delete(f.cacheKey),f.destroy()}}function A(f){a.remove(f)}function M(){a.dispose()}return{getParameters:_,getProgramCacheKey:x,getUniforms:y,acquireProgram:C,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:M}}function Z1(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function J1(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function h0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function u0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let p=0;return h.isInstancedMesh&&(p+=2),h.isSkinnedMesh&&(p+=1),p}function a(h,p,_,x,g,m){let y=n[t];return y===void 0?(y={id:h.id,object:h,geometry:p,material:_,materialVariant:o(h),groupOrder:x,renderOrder:h.renderOrder,z:g,group:m},n[t]=y):(y.id=h.id,y.object=h,y.geometry=p,y.material=_,y.materialVariant=o(h),y.groupOrder=x,y.renderOrder=h.renderOrder,y.z=g,y.group=m),t++,y}function l(h,p,_,x,g,m,y){y.reversedDepth===!0&&(g=-g);let C=a(h,p,_,x,g,m);_.transmission>0?i.push(C):_.transparent===!0?s.push(C):e.push(C)}function c(h,p,_,x,g,m){let y=a(h,p,_,x,g,m);_.transmission>0?i.unshift(y):_.transparent===!0?s.unshift(y):e.unshift(y)}function u(h,p){e.length>1&&e.sort(h||J1),i.length>1&&i.sort(p||h0),s.length>1&&s.sort(p||h0)}function d(){for(let h=t,p=n.length;h<p;h++){let _=n[h];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function j1(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new u0,n.set(i,[o])):s>=r.length?(o=new u0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function K1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new le};break;case"SpotLight":e={position:new X,direction:new X,color:new le,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new le,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new le,groundColor:new le};break;case"RectAreaLight":e={color:new le,position:new X,halfWidth:new X,halfHeight:new X};break}return n[t.id]=e,e}}}function Q1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var tw=0;function ew(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function nw(n){let t=new K1,e=Q1(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new De,o=new De;function a(c){let u=0,d=0,h=0;for(let U=0;U<9;U++)i.probe[U].set(0,0,0);let p=0,_=0,x=0,g=0,m=0,y=0,C=0,b=0,A=0,M=0,f=0,S=0,I=0,R=0;c.sort(ew);for(let U=0,B=c.length;U<B;U++){let D=c[U],k=D.color,q=D.intensity,O=D.distance,it=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===js?it=D.shadow.map.texture:it=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=k.r*q,d+=k.g*q,h+=k.b*q;else if(D.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(D.sh.coefficients[Y],q);R++}else if(D.isSunLight){let Y=t.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,tt=e.get(D);tt.shadowIntensity=K.intensity,tt.shadowBias=K.bias,tt.shadowNormalBias=K.normalBias,tt.shadowRadius=K.radius,tt.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[_]=tt,i.sunShadowMap[_]=it;let ht=K.getViewportCount();for(let et=0;et<ht;et++)i.sunShadowMatrix[x+et]=K.getMatrix(et),i.sunShadowCascade[x+et]=K._cascadeData[et];x+=ht,_++}i.sun[p]=Y,p++}else if(D.isDirectionalLight){let Y=t.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,tt=e.get(D);tt.shadowIntensity=K.intensity,tt.shadowBias=K.bias,tt.shadowNormalBias=K.normalBias,tt.shadowRadius=K.radius,tt.shadowMapSize=K.mapSize,i.directionalShadow[g]=tt,i.directionalShadowMap[g]=it,i.directionalShadowMatrix[g]=D.shadow.matrix,A++}i.directional[g]=Y,g++}else if(D.isSpotLight){let Y=t.get(D);Y.position.setFromMatrixPosition(D.matrixWorld),Y.color.copy(k).multiplyScalar(q),Y.distance=O,Y.coneCos=Math.cos(D.angle),Y.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Y.decay=D.decay,i.spot[y]=Y;let K=D.shadow;if(D.map&&(i.spotLightMap[S]=D.map,S++,K.updateMatrices(D),D.castShadow&&I++),i.spotLightMatrix[y]=K.matrix,D.castShadow){let tt=e.get(D);tt.shadowIntensity=K.intensity,tt.shadowBias=K.bias,tt.shadowNormalBias=K.normalBias,tt.shadowRadius=K.radius,tt.shadowMapSize=K.mapSize,i.spotShadow[y]=tt,i.spotShadowMap[y]=it,f++}y++}else if(D.isRectAreaLight){let Y=t.get(D);Y.color.copy(k).multiplyScalar(q),Y.halfWidth.set(D.width*.5,0,0),Y.halfHeight.set(0,D.height*.5,0),i.rectArea[C]=Y,C++}else if(D.isPointLight){let Y=t.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),Y.distance=D.distance,Y.decay=D.decay,D.castShadow){let K=D.shadow,tt=e.get(D);tt.shadowIntensity=K.intensity,tt.shadowBias=K.bias,tt.shadowNormalBias=K.normalBias,tt.shadowRadius=K.radius,tt.shadowMapSize=K.mapSize,tt.shadowCameraNear=K.camera.near,tt.shadowCameraFar=K.camera.far,i.pointShadow[m]=tt,i.pointShadowMap[m]=it,i.pointShadowMatrix[m]=D.shadow.matrix,M++}i.point[m]=Y,m++}else if(D.isHemisphereLight){let Y=t.get(D);Y.skyColor.copy(D.color).multiplyScalar(q),Y.groundColor.copy(D.groundColor).multiplyScalar(q),i.hemi[b]=Y,b++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Pt.LTC_FLOAT_1,i.rectAreaLTC2=Pt.LTC_FLOAT_2):(i.rectAreaLTC1=Pt.LTC_HALF_1,i.rectAreaLTC2=Pt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let P=i.hash;(P.sunLength!==p||P.directionalLength!==g||P.pointLength!==m||P.spotLength!==y||P.rectAreaLength!==C||P.hemiLength!==b||P.numSunShadows!==_||P.numDirectionalShadows!==A||P.numPointShadows!==M||P.numSpotShadows!==f||P.numSpotMaps!==S||P.numLightProbes!==R)&&(i.sun.length=p,i.directional.length=g,i.spot.length=y,i.rectArea.length=C,i.point.length=m,i.hemi.length=b,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=f,i.spotShadowMap.length=f,i.spotLightMatrix.length=f+S-I,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=R,P.sunLength=p,P.directionalLength=g,P.pointLength=m,P.spotLength=y,P.rectAreaLength=C,P.hemiLength=b,P.numSunShadows=_,P.numDirectionalShadows=A,P.numPointShadows=M,P.numSpotShadows=f,P.numSpotMaps=S,P.numLightProbes=R,i.version=tw++)}function l(c,u){let d=0,h=0,p=0,_=0,x=0,g=0,m=u.matrixWorldInverse;for(let y=0,C=c.length;y<C;y++){let b=c[y];if(b.isSunLight){let A=i.sun[d];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),d++}else if(b.isDirectionalLight){let A=i.directional[h];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),h++}else if(b.isSpotLight){let A=i.spot[_];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),_++}else if(b.isRectAreaLight){let A=i.rectArea[x];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let A=i.point[p];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),p++}else if(b.isHemisphereLight){let A=i.hemi[g];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function d0(n){let t=new nw(n),e=[],i=[],s=[];function r(d){u.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){t.setupView(e,d)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function iw(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new d0(n),t.set(s,[a])):r>=o.length?(a=new d0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var sw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,rw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,ow=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],aw=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],f0=new De,Za=new X,qd=new X;function lw(n,t,e){let i=new Gs,s=new Jt,r=new Jt,o=new Re,a=new xc,l=new yc,c={},u=e.maxTextureSize,d={[Js]:jn,[jn]:Js,[es]:es},h=new bi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Jt},radius:{value:4}},vertexShader:sw,fragmentShader:rw}),p=h.clone();p.defines.HORIZONTAL_PASS=1;let _=new ti;_.setAttribute("position",new Ni(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Fn(_,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ka;let m=this.type;this.render=function(M,f,S){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||M.length===0)return;this.type===hg&&($t("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ka);let I=n.getRenderTarget(),R=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),U=n.state;U.setBlending(vr),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let B=m!==this.type;B&&f.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(k=>k.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,k=M.length;D<k;D++){let q=M[D],O=q.shadow;if(O===void 0){$t("WebGLShadowMap:",q,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;s.copy(O.mapSize);let it=O.getFrameExtents();s.multiply(it),r.copy(O.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/it.x),s.x=r.x*it.x,O.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/it.y),s.y=r.y*it.y,O.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=Y,O.map===null||B===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===Eo){if(q.isPointLight){$t("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new pi(s.x,s.y,{format:js,type:zi,minFilter:$n,magFilter:$n,generateMipmaps:!1}),O.map.texture.name=q.name+".shadowMap",O.map.depthTexture=new Ms(s.x,s.y,ki),O.map.depthTexture.name=q.name+".shadowMapDepth",O.map.depthTexture.format=vs,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=fn,O.map.depthTexture.magFilter=fn}else q.isPointLight?(O.map=new ja(s.x),O.map.depthTexture=new ba(s.x,Bi)):(O.map=new pi(s.x,s.y),O.map.depthTexture=new Ms(s.x,s.y,Bi)),O.map.depthTexture.name=q.name+".shadowMap",O.map.depthTexture.format=vs,this.type===ka?(O.map.depthTexture.compareFunction=Y?Cd:Ad,O.map.depthTexture.minFilter=$n,O.map.depthTexture.magFilter=$n):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=fn,O.map.depthTexture.magFilter=fn);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==s.x||O.map.height!==s.y)&&O.map.setSize(s.x,s.y);let K=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();q.isPointLight!==!0&&O.updateMatrices(q,S);let tt=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:S.layers;for(let ht=0;ht<K;ht++){let et=O.getCamera(ht);if(q.isPointLight){let $=O.camera,ft=O.matrix,gt=q.distance||$.far;gt!==$.far&&($.far=gt,$.updateProjectionMatrix()),Za.setFromMatrixPosition(q.matrixWorld),$.position.copy(Za),qd.copy($.position),qd.add(ow[ht]),$.up.copy(aw[ht]),$.lookAt(qd),$.updateMatrixWorld(),ft.makeTranslation(-Za.x,-Za.y,-Za.z),f0.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),O._frustum.setFromProjectionMatrix(f0,$.coordinateSystem,$.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,ht),n.clear();else{ht===0&&(n.setRenderTarget(O.map),n.clear());let $=O.getViewport(ht);o.set(r.x*$.x,r.y*$.y,r.x*$.z,r.y*$.w),U.viewport(o)}i=O.getFrustum(ht),b(f,S,et,q,tt,this.type)}O.isPointLightShadow!==!0&&this.type===Eo&&y(O,S),O.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(I,R,P)};function y(M,f){let S=t.update(x);h.defines.VSM_SAMPLES!==M.blurSamples&&(h.defines.VSM_SAMPLES=M.blurSamples,p.defines.VSM_SAMPLES=M.blurSamples,h.needsUpdate=!0,p.needsUpdate=!0),M.mapPass===null?M.mapPass=new pi(s.x,s.y,{format:js,type:zi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),h.uniforms.shadow_pass.value=M.map.depthTexture,h.uniforms.resolution.value.set(M.map.width,M.map.height),h.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(f,null,S,h,x,null),p.uniforms.shadow_pass.value=M.mapPass.texture,p.uniforms.resolution.value.set(M.map.width,M.map.height),p.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(f,null,S,p,x,null)}function C(M,f,S,I){let R=null,P=S.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(P!==void 0)R=P;else if(R=S.isPointLight===!0?l:a,n.localClippingEnabled&&f.clipShadows===!0&&Array.isArray(f.clippingPlanes)&&f.clippingPlanes.length!==0||f.displacementMap&&f.displacementScale!==0||f.alphaMap&&f.alphaTest>0||f.map&&f.alphaTest>0||f.alphaToCoverage===!0){let U=R.uuid,B=f.uuid,D=c[U];D===void 0&&(D={},c[U]=D);let k=D[B];k===void 0&&(k=R.clone(),D[B]=k,f.addEventListener("dispose",A)),R=k}if(R.visible=f.visible,R.wireframe=f.wireframe,I===Eo?R.side=f.shadowSide!==null?f.shadowSide:f.side:R.side=f.shadowSide!==null?f.shadowSide:d[f.side],R.alphaMap=f.alphaMap,R.alphaTest=f.alphaToCoverage===!0?.5:f.alphaTest,R.map=f.map,R.clipShadows=f.clipShadows,R.clippingPlanes=f.clippingPlanes,R.clipIntersection=f.clipIntersection,R.displacementMap=f.displacementMap,R.displacementScale=f.displacementScale,R.displacementBias=f.displacementBias,R.wireframeLinewidth=f.wireframeLinewidth,R.linewidth=f.linewidth,S.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let U=n.properties.get(R);U.light=S}return R}function b(M,f,S,I,R,P){if(M.visible===!1)return;if(M.layers.test(R)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&P===Eo)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,M.matrixWorld);let D=t.update(M),k=M.material;if(Array.isArray(k)){let q=D.groups;for(let O=0,it=q.length;O<it;O++){let Y=q[O],K=k[Y.materialIndex];if(K&&K.visible){let tt=C(M,K,I,P);M.onBeforeShadow(n,M,f,S,D,tt,Y),n.renderBufferDirect(S,null,D,tt,M,Y),M.onAfterShadow(n,M,f,S,D,tt,Y)}}}else if(k.visible){let q=C(M,k,I,P);M.onBeforeShadow(n,M,f,S,D,q,null),n.renderBufferDirect(S,null,D,q,M,null),M.onAfterShadow(n,M,f,S,D,q,null)}}let B=M.children;for(let D=0,k=B.length;D<k;D++)b(B[D],f,S,I,R,P)}function A(M){M.target.removeEventListener("dispose",A);for(let S in c){let I=c[S],R=M.target.uuid;R in I&&(I[R].dispose(),delete I[R])}}}function cw(n,t){function e(){let z=!1,at=new Re,rt=null,Et=new Re(0,0,0,0);return{setMask:function(xt){rt!==xt&&!z&&(n.colorMask(xt,xt,xt,xt),rt=xt)},setLocked:function(xt){z=xt},setClear:function(xt,bt,Wt,Qt,ut){ut===!0&&(xt*=Qt,bt*=Qt,Wt*=Qt),at.set(xt,bt,Wt,Qt),Et.equals(at)===!1&&(n.clearColor(xt,bt,Wt,Qt),Et.copy(at))},reset:function(){z=!1,rt=null,Et.set(-1,0,0,0)}}}function i(){let z=!1,at=!1,rt=null,Et=null,xt=null;return{setReversed:function(bt){if(at!==bt){let Wt=t.get("EXT_clip_control");bt?Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.ZERO_TO_ONE_EXT):Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.NEGATIVE_ONE_TO_ONE_EXT),at=bt;let Qt=xt;xt=null,this.setClear(Qt)}},getReversed:function(){return at},setTest:function(bt){bt?_t(n.DEPTH_TEST):Ft(n.DEPTH_TEST)},setMask:function(bt){rt!==bt&&!z&&(n.depthMask(bt),rt=bt)},setFunc:function(bt){if(at&&(bt=Hg[bt]),Et!==bt){switch(bt){case Jl:n.depthFunc(n.NEVER);break;case jl:n.depthFunc(n.ALWAYS);break;case Kl:n.depthFunc(n.LESS);break;case mo:n.depthFunc(n.LEQUAL);break;case Ql:n.depthFunc(n.EQUAL);break;case tc:n.depthFunc(n.GEQUAL);break;case ec:n.depthFunc(n.GREATER);break;case nc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=bt}},setLocked:function(bt){z=bt},setClear:function(bt){xt!==bt&&(xt=bt,at&&(bt=1-bt),n.clearDepth(bt))},reset:function(){z=!1,rt=null,Et=null,xt=null,at=!1}}}function s(){let z=!1,at=null,rt=null,Et=null,xt=null,bt=null,Wt=null,Qt=null,ut=null;return{setTest:function(kt){z||(kt?_t(n.STENCIL_TEST):Ft(n.STENCIL_TEST))},setMask:function(kt){at!==kt&&!z&&(n.stencilMask(kt),at=kt)},setFunc:function(kt,te,Ct){(rt!==kt||Et!==te||xt!==Ct)&&(n.stencilFunc(kt,te,Ct),rt=kt,Et=te,xt=Ct)},setOp:function(kt,te,Ct){(bt!==kt||Wt!==te||Qt!==Ct)&&(n.stencilOp(kt,te,Ct),bt=kt,Wt=te,Qt=Ct)},setLocked:function(kt){z=kt},setClear:function(kt){ut!==kt&&(n.clearStencil(kt),ut=kt)},reset:function(){z=!1,at=null,rt=null,Et=null,xt=null,bt=null,Wt=null,Qt=null,ut=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},p=new WeakMap,_=[],x=null,g=!1,m=null,y=null,C=null,b=null,A=null,M=null,f=null,S=new le(0,0,0),I=0,R=!1,P=null,U=null,B=null,D=null,k=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,it=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(it=parseFloat(/^WebGL (\d)/.exec(Y)[1]),O=it>=1):Y.indexOf("OpenGL ES")!==-1&&(it=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),O=it>=2);let K=null,tt={},ht=n.getParameter(n.SCISSOR_BOX),et=n.getParameter(n.VIEWPORT),$=new Re().fromArray(ht),ft=new Re().fromArray(et);function gt(z,at,rt,Et){let xt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(z,bt),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Wt=0;Wt<rt;Wt++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(at,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(at+Wt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return bt}let vt={};vt[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),vt[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),vt[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),vt[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),_t(n.DEPTH_TEST),o.setFunc(mo),sn(!1),Ne(rd),_t(n.CULL_FACE),Ye(vr);function _t(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function Ft(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function qt(z,at){return h[z]!==at?(n.bindFramebuffer(z,at),h[z]=at,z===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=at),z===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=at),!0):!1}function Ot(z,at){let rt=_,Et=!1;if(z){rt=p.get(at),rt===void 0&&(rt=[],p.set(at,rt));let xt=z.textures;if(rt.length!==xt.length||rt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Wt=xt.length;bt<Wt;bt++)rt[bt]=n.COLOR_ATTACHMENT0+bt;rt.length=xt.length,Et=!0}}else rt[0]!==n.BACK&&(rt[0]=n.BACK,Et=!0);Et&&n.drawBuffers(rt)}function ce(z){return x!==z?(n.useProgram(z),x=z,!0):!1}let he={[Sr]:n.FUNC_ADD,[dg]:n.FUNC_SUBTRACT,[fg]:n.FUNC_REVERSE_SUBTRACT};he[pg]=n.MIN,he[mg]=n.MAX;let Kt={[gg]:n.ZERO,[_g]:n.ONE,[xg]:n.SRC_COLOR,[cd]:n.SRC_ALPHA,[wg]:n.SRC_ALPHA_SATURATE,[Mg]:n.DST_COLOR,[vg]:n.DST_ALPHA,[yg]:n.ONE_MINUS_SRC_COLOR,[hd]:n.ONE_MINUS_SRC_ALPHA,[bg]:n.ONE_MINUS_DST_COLOR,[Sg]:n.ONE_MINUS_DST_ALPHA,[Eg]:n.CONSTANT_COLOR,[Tg]:n.ONE_MINUS_CONSTANT_COLOR,[Ag]:n.CONSTANT_ALPHA,[Cg]:n.ONE_MINUS_CONSTANT_ALPHA};function Ye(z,at,rt,Et,xt,bt,Wt,Qt,ut,kt){if(z===vr){g===!0&&(Ft(n.BLEND),g=!1);return}if(g===!1&&(_t(n.BLEND),g=!0),z!==ug){if(z!==m||kt!==R){if((y!==Sr||A!==Sr)&&(n.blendEquation(n.FUNC_ADD),y=Sr,A=Sr),kt)switch(z){case To:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case od:n.blendFunc(n.ONE,n.ONE);break;case ad:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case ld:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ie("WebGLState: Invalid blending: ",z);break}else switch(z){case To:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case od:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case ad:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ld:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",z);break}C=null,b=null,M=null,f=null,S.set(0,0,0),I=0,m=z,R=kt}return}xt=xt||at,bt=bt||rt,Wt=Wt||Et,(at!==y||xt!==A)&&(n.blendEquationSeparate(he[at],he[xt]),y=at,A=xt),(rt!==C||Et!==b||bt!==M||Wt!==f)&&(n.blendFuncSeparate(Kt[rt],Kt[Et],Kt[bt],Kt[Wt]),C=rt,b=Et,M=bt,f=Wt),(Qt.equals(S)===!1||ut!==I)&&(n.blendColor(Qt.r,Qt.g,Qt.b,ut),S.copy(Qt),I=ut),m=z,R=!1}function ke(z,at){z.side===es?Ft(n.CULL_FACE):_t(n.CULL_FACE);let rt=z.side===jn;at&&(rt=!rt),sn(rt),z.blending===To&&z.transparent===!1?Ye(vr):Ye(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Et=z.stencilWrite;a.setTest(Et),Et&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),ve(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?_t(n.SAMPLE_ALPHA_TO_COVERAGE):Ft(n.SAMPLE_ALPHA_TO_COVERAGE)}function sn(z){P!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),P=z)}function Ne(z){z!==lg?(_t(n.CULL_FACE),z!==U&&(z===rd?n.cullFace(n.BACK):z===cg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ft(n.CULL_FACE),U=z}function Sn(z){z!==B&&(O&&n.lineWidth(z),B=z)}function ve(z,at,rt){z?(_t(n.POLYGON_OFFSET_FILL),(D!==at||k!==rt)&&(D=at,k=rt,o.getReversed()&&(at=-at,rt=-rt),n.polygonOffset(at,rt))):Ft(n.POLYGON_OFFSET_FILL)}function pn(z){z?_t(n.SCISSOR_TEST):Ft(n.SCISSOR_TEST)}function Je(z){z===void 0&&(z=n.TEXTURE0+q-1),K!==z&&(n.activeTexture(z),K=z)}function rn(z,at,rt){rt===void 0&&(K===null?rt=n.TEXTURE0+q-1:rt=K);let Et=tt[rt];Et===void 0&&(Et={type:void 0,texture:void 0},tt[rt]=Et),(Et.type!==z||Et.texture!==at)&&(K!==rt&&(n.activeTexture(rt),K=rt),n.bindTexture(z,at||vt[z]),Et.type=z,Et.texture=at)}function V(){let z=tt[K];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function Zt(){try{n.compressedTexImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function oe(){try{n.texSubImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function wt(){try{n.texSubImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function Fe(){try{n.compressedTexSubImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function Ht(){try{n.compressedTexSubImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function Yt(){try{n.texStorage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function L(){try{n.texStorage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function w(){try{n.texImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function Z(){try{n.texImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function dt(z){return d[z]!==void 0?d[z]:n.getParameter(z)}function lt(z,at){d[z]!==at&&(n.pixelStorei(z,at),d[z]=at)}function yt(z){$.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),$.copy(z))}function St(z){ft.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),ft.copy(z))}function st(z,at){let rt=c.get(at);rt===void 0&&(rt=new WeakMap,c.set(at,rt));let Et=rt.get(z);Et===void 0&&(Et=n.getUniformBlockIndex(at,z.name),n.uniformBlockBinding(at,Et,Et),rt.set(z,Et))}function ot(z,at,rt){let xt=c.get(at).get(z);l[xt]!==rt&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,rt),l[xt]=rt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},K=null,tt={},h={},l={},p=new WeakMap,_=[],x=null,g=!1,m=null,y=null,C=null,b=null,A=null,M=null,f=null,S=new le(0,0,0),I=0,R=!1,P=null,U=null,B=null,D=null,k=null,$.set(0,0,n.canvas.width,n.canvas.height),ft.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:_t,disable:Ft,bindFramebuffer:qt,drawBuffers:Ot,useProgram:ce,setBlending:Ye,setMaterial:ke,setFlipSided:sn,setCullFace:Ne,setLineWidth:Sn,setPolygonOffset:ve,setScissorTest:pn,activeTexture:Je,bindTexture:rn,unbindTexture:V,compressedTexImage2D:Rt,compressedTexImage3D:Zt,texImage2D:w,texImage3D:Z,pixelStorei:lt,getParameter:dt,updateUBOMapping:st,uniformBlockBinding:ot,texStorage2D:Yt,texStorage3D:L,texSubImage2D:oe,texSubImage3D:wt,compressedTexSubImage2D:Fe,compressedTexSubImage3D:Ht,scissor:yt,viewport:St,reset:mt}}function hw(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Jt,u=new WeakMap,d=new Set,h,p=new WeakMap,_=new Set,x=new FinalizationRegistry(L=>_.delete(L)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(L,w){return g?new OffscreenCanvas(L,w):fa("canvas")}function y(L,w,Z){let dt=1,lt=Yt(L);if((lt.width>Z||lt.height>Z)&&(dt=Z/Math.max(lt.width,lt.height)),dt<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let yt=Math.floor(dt*lt.width),St=Math.floor(dt*lt.height);h===void 0&&(h=m(yt,St));let st=w?m(yt,St):h;return st.width=yt,st.height=St,st.getContext("2d").drawImage(L,0,0,yt,St),$t("WebGLRenderer: Texture has been resized from ("+lt.width+"x"+lt.height+") to ("+yt+"x"+St+")."),st}else return"data"in L&&$t("WebGLRenderer: Image in DataTexture is too big ("+lt.width+"x"+lt.height+")."),L;return L}function C(L){return L.generateMipmaps}function b(L){n.generateMipmap(L)}function A(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(L,w,Z,dt,lt,yt=!1){if(L!==null){if(n[L]!==void 0)return n[L];$t("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let St;dt&&(St=t.get("EXT_texture_norm16"),St||$t("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let st=w;if(w===n.RED&&(Z===n.FLOAT&&(st=n.R32F),Z===n.HALF_FLOAT&&(st=n.R16F),Z===n.UNSIGNED_BYTE&&(st=n.R8),Z===n.UNSIGNED_SHORT&&St&&(st=St.R16_EXT),Z===n.SHORT&&St&&(st=St.R16_SNORM_EXT)),w===n.RED_INTEGER&&(Z===n.UNSIGNED_BYTE&&(st=n.R8UI),Z===n.UNSIGNED_SHORT&&(st=n.R16UI),Z===n.UNSIGNED_INT&&(st=n.R32UI),Z===n.BYTE&&(st=n.R8I),Z===n.SHORT&&(st=n.R16I),Z===n.INT&&(st=n.R32I)),w===n.RG&&(Z===n.FLOAT&&(st=n.RG32F),Z===n.HALF_FLOAT&&(st=n.RG16F),Z===n.UNSIGNED_BYTE&&(st=n.RG8),Z===n.UNSIGNED_SHORT&&St&&(st=St.RG16_EXT),Z===n.SHORT&&St&&(st=St.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(Z===n.UNSIGNED_BYTE&&(st=n.RG8UI),Z===n.UNSIGNED_SHORT&&(st=n.RG16UI),Z===n.UNSIGNED_INT&&(st=n.RG32UI),Z===n.BYTE&&(st=n.RG8I),Z===n.SHORT&&(st=n.RG16I),Z===n.INT&&(st=n.RG32I)),w===n.RGB_INTEGER&&(Z===n.UNSIGNED_BYTE&&(st=n.RGB8UI),Z===n.UNSIGNED_SHORT&&(st=n.RGB16UI),Z===n.UNSIGNED_INT&&(st=n.RGB32UI),Z===n.BYTE&&(st=n.RGB8I),Z===n.SHORT&&(st=n.RGB16I),Z===n.INT&&(st=n.RGB32I)),w===n.RGBA_INTEGER&&(Z===n.UNSIGNED_BYTE&&(st=n.RGBA8UI),Z===n.UNSIGNED_SHORT&&(st=n.RGBA16UI),Z===n.UNSIGNED_INT&&(st=n.RGBA32UI),Z===n.BYTE&&(st=n.RGBA8I),Z===n.SHORT&&(st=n.RGBA16I),Z===n.INT&&(st=n.RGBA32I)),w===n.RGB&&(Z===n.UNSIGNED_SHORT&&St&&(st=St.RGB16_EXT),Z===n.SHORT&&St&&(st=St.RGB16_SNORM_EXT),Z===n.UNSIGNED_INT_5_9_9_9_REV&&(st=n.RGB9_E5),Z===n.UNSIGNED_INT_10F_11F_11F_REV&&(st=n.R11F_G11F_B10F)),w===n.RGBA){let ot=yt?da:ye.getTransfer(lt);Z===n.FLOAT&&(st=n.RGBA32F),Z===n.HALF_FLOAT&&(st=n.RGBA16F),Z===n.UNSIGNED_BYTE&&(st=ot===Ce?n.SRGB8_ALPHA8:n.RGBA8),Z===n.UNSIGNED_SHORT&&St&&(st=St.RGBA16_EXT),Z===n.SHORT&&St&&(st=St.RGBA16_SNORM_EXT),Z===n.UNSIGNED_SHORT_4_4_4_4&&(st=n.RGBA4),Z===n.UNSIGNED_SHORT_5_5_5_1&&(st=n.RGB5_A1)}return(st===n.R16F||st===n.R32F||st===n.RG16F||st===n.RG32F||st===n.RGBA16F||st===n.RGBA32F)&&t.get("EXT_color_buffer_float"),st}function f(L,w){let Z;return L?w===null||w===Bi||w===br?Z=n.DEPTH24_STENCIL8:w===ki?Z=n.DEPTH32F_STENCIL8:w===Co&&(Z=n.DEPTH24_STENCIL8,$t("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Bi||w===br?Z=n.DEPTH_COMPONENT24:w===ki?Z=n.DEPTH_COMPONENT32F:w===Co&&(Z=n.DEPTH_COMPONENT16),Z}function S(L,w){return C(L)===!0||L.isFramebufferTexture&&L.minFilter!==fn&&L.minFilter!==$n?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function I(L){let w=new WeakRef(L);i.get(L).__ref=w,_.add(w),x.register(L,w,w)}function R(L){let w=i.get(L).__ref;w!==void 0&&(_.delete(w),x.unregister(w))}function P(L){B(L.target)}function U(L){D(L.target)}function B(L){L.removeEventListener("dispose",P),R(L),q(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&d.delete(L)}function D(L){L.removeEventListener("dispose",U),R(L),it(L)}function k(){for(let L of _){let w=L.deref();w!==void 0&&(w.isRenderTarget===!0?D(w):B(w))}_.clear(),d.clear()}function q(L){let w=i.get(L);if(w.__webglInit===void 0)return;let Z=L.source,dt=p.get(Z);if(dt){let lt=dt[w.__cacheKey];lt.usedTimes--,lt.usedTimes===0&&O(L),Object.keys(dt).length===0&&p.delete(Z)}i.remove(L)}function O(L){let w=i.get(L);n.deleteTexture(w.__webglTexture);let Z=L.source,dt=p.get(Z);delete dt[w.__cacheKey],o.memory.textures--}function it(L){let w=i.get(L);w.__depthDisposeCallback&&w.__depthDisposeCallback();let Z=L.depthTexture;if(Z&&Z.renderTarget===L&&B(Z),L.isWebGLCubeRenderTarget)for(let lt=0;lt<6;lt++){if(Array.isArray(w.__webglFramebuffer[lt]))for(let yt=0;yt<w.__webglFramebuffer[lt].length;yt++)n.deleteFramebuffer(w.__webglFramebuffer[lt][yt]);else n.deleteFramebuffer(w.__webglFramebuffer[lt]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[lt])}else{if(Array.isArray(w.__webglFramebuffer))for(let lt=0;lt<w.__webglFramebuffer.length;lt++)n.deleteFramebuffer(w.__webglFramebuffer[lt]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let lt=0;lt<w.__webglColorRenderbuffer.length;lt++)w.__webglColorRenderbuffer[lt]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[lt]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let dt=L.textures;for(let lt=0,yt=dt.length;lt<yt;lt++){let St=i.get(dt[lt]);St.__webglTexture&&(n.deleteTexture(St.__webglTexture),o.memory.textures--),i.remove(dt[lt])}i.remove(L)}let Y=0;function K(){Y=0}function tt(){return Y}function ht(L){Y=L}function et(){let L=Y;return L>=s.maxTextures&&$t("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,L}function $(L){let w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.mipmapsAutoUpdate),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function ft(L,w){let Z=i.get(L);if(L.isVideoTexture&&Fe(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Z.__version!==L.version){let dt=L.image;if(dt===null)$t("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)$t("WebGLRenderer: Texture marked for update but image is incomplete");else{ke(Z,L,w);return}}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Z.__webglTexture,n.TEXTURE0+w)}function gt(L,w){let Z=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){ke(Z,L,w);return}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Z.__webglTexture,n.TEXTURE0+w)}function vt(L,w){let Z=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){ke(Z,L,w);return}e.bindTexture(n.TEXTURE_3D,Z.__webglTexture,n.TEXTURE0+w)}function _t(L,w){let Z=i.get(L);if(L.version>0&&Z.__version!==L.version){sn(Z,L,w);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture,n.TEXTURE0+w)}let Ft={[ic]:n.REPEAT,[Qi]:n.CLAMP_TO_EDGE,[sc]:n.MIRRORED_REPEAT},qt={[fn]:n.NEAREST,[Ig]:n.NEAREST_MIPMAP_NEAREST,[za]:n.NEAREST_MIPMAP_LINEAR,[$n]:n.LINEAR,[Uc]:n.LINEAR_MIPMAP_NEAREST,[bs]:n.LINEAR_MIPMAP_LINEAR},Ot={[Ug]:n.NEVER,[Rd]:n.ALWAYS,[Fg]:n.LESS,[Ad]:n.LEQUAL,[Og]:n.EQUAL,[Cd]:n.GEQUAL,[Bg]:n.GREATER,[kg]:n.NOTEQUAL};function ce(L,w){if(w.type===ki&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===$n||w.magFilter===Uc||w.magFilter===za||w.magFilter===bs||w.minFilter===$n||w.minFilter===Uc||w.minFilter===za||w.minFilter===bs)&&$t("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,Ft[w.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,Ft[w.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,Ft[w.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,qt[w.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,qt[w.minFilter]),w.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Ot[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===fn||w.minFilter!==za&&w.minFilter!==bs||w.type===ki&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let Z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function he(L,w){let Z=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",P),I(w));let dt=w.source,lt=p.get(dt);lt===void 0&&(lt={},p.set(dt,lt));let yt=$(w);if(yt!==L.__cacheKey){lt[yt]===void 0&&(lt[yt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),lt[yt].usedTimes++;let St=lt[L.__cacheKey];St!==void 0&&(lt[L.__cacheKey].usedTimes--,St.usedTimes===0&&O(w)),L.__cacheKey=yt,L.__webglTexture=lt[yt].texture}return Z}function Kt(L,w,Z){return Math.floor(Math.floor(L/Z)/w)}function Ye(L,w,Z,dt){let yt=L.updateRanges;if(yt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,Z,dt,w.data);else{yt.sort((z,at)=>z.start-at.start);let St=0;for(let z=1;z<yt.length;z++){let at=yt[St],rt=yt[z],Et=at.start+at.count,xt=Kt(rt.start,w.width,4),bt=Kt(at.start,w.width,4);rt.start<=Et+1&&xt===bt&&Kt(rt.start+rt.count-1,w.width,4)===xt?at.count=Math.max(at.count,rt.start+rt.count-at.start):(++St,yt[St]=rt)}yt.length=St+1;let st=e.getParameter(n.UNPACK_ROW_LENGTH),ot=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let z=0,at=yt.length;z<at;z++){let rt=yt[z],Et=Math.floor(rt.start/4),xt=Math.ceil(rt.count/4),bt=Et%w.width,Wt=Math.floor(Et/w.width),Qt=xt,ut=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Wt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Wt,Qt,ut,Z,dt,w.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,st),e.pixelStorei(n.UNPACK_SKIP_PIXELS,ot),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function ke(L,w,Z){let dt=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(dt=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(dt=n.TEXTURE_3D);let lt=he(L,w),yt=w.source;e.bindTexture(dt,L.__webglTexture,n.TEXTURE0+Z);let St=i.get(yt);if(yt.version!==St.__version||lt===!0){if(e.activeTexture(n.TEXTURE0+Z),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ut=ye.getPrimaries(ye.workingColorSpace),kt=w.colorSpace===Es?null:ye.getPrimaries(w.colorSpace),te=w.colorSpace===Es||ut===kt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let ot=y(w.image,!1,s.maxTextureSize);ot=Ht(w,ot);let mt=r.convert(w.format,w.colorSpace),z=r.convert(w.type),at=M(w.internalFormat,mt,z,w.normalized,w.colorSpace,w.isVideoTexture);ce(dt,w);let rt,Et=w.mipmaps,xt=w.isVideoTexture!==!0,bt=St.__version===void 0||lt===!0,Wt=yt.dataReady,Qt=S(w,ot);if(w.isDepthTexture)at=f(w.format===ws,w.type),bt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,at,ot.width,ot.height):e.texImage2D(n.TEXTURE_2D,0,at,ot.width,ot.height,0,mt,z,null));else if(w.isDataTexture)if(Et.length>0){xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Qt,at,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)rt=Et[ut],xt?Wt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,rt.width,rt.height,mt,z,rt.data):e.texImage2D(n.TEXTURE_2D,ut,at,rt.width,rt.height,0,mt,z,rt.data);w.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(n.TEXTURE_2D,Qt,at,ot.width,ot.height),Wt&&Ye(w,ot,mt,z)):e.texImage2D(n.TEXTURE_2D,0,at,ot.width,ot.height,0,mt,z,ot.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,at,Et[0].width,Et[0].height,ot.depth);for(let ut=0,kt=Et.length;ut<kt;ut++)if(rt=Et[ut],w.format!==Vi)if(mt!==null)if(xt){if(Wt)if(w.layerUpdates.size>0){let te=kd(rt.width,rt.height,w.format,w.type);for(let Ct of w.layerUpdates){let ue=rt.data.subarray(Ct*te/rt.data.BYTES_PER_ELEMENT,(Ct+1)*te/rt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,Ct,rt.width,rt.height,1,mt,ue)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,rt.width,rt.height,ot.depth,mt,rt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ut,at,rt.width,rt.height,ot.depth,0,rt.data,0,0);else $t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Wt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,rt.width,rt.height,ot.depth,mt,z,rt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ut,at,rt.width,rt.height,ot.depth,0,mt,z,rt.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Qt,at,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)rt=Et[ut],w.format!==Vi?mt!==null?xt?Wt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ut,0,0,rt.width,rt.height,mt,rt.data):e.compressedTexImage2D(n.TEXTURE_2D,ut,at,rt.width,rt.height,0,rt.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Wt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,rt.width,rt.height,mt,z,rt.data):e.texImage2D(n.TEXTURE_2D,ut,at,rt.width,rt.height,0,mt,z,rt.data)}else if(w.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,at,ot.width,ot.height,ot.depth),Wt)if(w.layerUpdates.size>0){let ut=kd(ot.width,ot.height,w.format,w.type);for(let kt of w.layerUpdates){let te=ot.data.subarray(kt*ut/ot.data.BYTES_PER_ELEMENT,(kt+1)*ut/ot.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,kt,ot.width,ot.height,1,mt,z,te)}w.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ot.width,ot.height,ot.depth,mt,z,ot.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,at,ot.width,ot.height,ot.depth,0,mt,z,ot.data);else if(w.isData3DTexture)xt?(bt&&e.texStorage3D(n.TEXTURE_3D,Qt,at,ot.width,ot.height,ot.depth),Wt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ot.width,ot.height,ot.depth,mt,z,ot.data)):e.texImage3D(n.TEXTURE_3D,0,at,ot.width,ot.height,ot.depth,0,mt,z,ot.data);else if(w.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(n.TEXTURE_2D,Qt,at,ot.width,ot.height);else{let ut=ot.width,kt=ot.height;for(let te=0;te<Qt;te++)e.texImage2D(n.TEXTURE_2D,te,at,ut,kt,0,mt,z,null),ut>>=1,kt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ut=n.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),ot.parentNode!==ut){ut.appendChild(ot),d.add(w),ut.onpaint=kt=>{let te=kt.changedElements;for(let Ct of d)te.includes(Ct.image)&&(Ct.needsUpdate=!0)},ut.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ot);else{let te=n.RGBA,Ct=n.RGBA,ue=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,te,Ct,ue,ot)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(xt&&bt){let ut=Yt(Et[0]);e.texStorage2D(n.TEXTURE_2D,Qt,at,ut.width,ut.height)}for(let ut=0,kt=Et.length;ut<kt;ut++)rt=Et[ut],xt?Wt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,mt,z,rt):e.texImage2D(n.TEXTURE_2D,ut,at,mt,z,rt);w.generateMipmaps=!1}else if(xt){if(bt){let ut=Yt(ot);e.texStorage2D(n.TEXTURE_2D,Qt,at,ut.width,ut.height)}Wt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,z,ot)}else e.texImage2D(n.TEXTURE_2D,0,at,mt,z,ot);C(w)&&w.mipmapsAutoUpdate===!0&&b(dt),St.__version=yt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function sn(L,w,Z){if(w.image.length!==6)return;let dt=he(L,w),lt=w.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+Z);let yt=i.get(lt);if(lt.version!==yt.__version||dt===!0){e.activeTexture(n.TEXTURE0+Z);let St=ye.getPrimaries(ye.workingColorSpace),st=w.colorSpace===Es?null:ye.getPrimaries(w.colorSpace),ot=w.colorSpace===Es||St===st?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ot);let mt=w.isCompressedTexture||w.image[0].isCompressedTexture,z=w.image[0]&&w.image[0].isDataTexture,at=[];for(let Ct=0;Ct<6;Ct++)!mt&&!z?at[Ct]=y(w.image[Ct],!0,s.maxCubemapSize):at[Ct]=z?w.image[Ct].image:w.image[Ct],at[Ct]=Ht(w,at[Ct]);let rt=at[0],Et=r.convert(w.format,w.colorSpace),xt=r.convert(w.type),bt=M(w.internalFormat,Et,xt,w.normalized,w.colorSpace),Wt=w.isVideoTexture!==!0,Qt=yt.__version===void 0||dt===!0,ut=lt.dataReady,kt=S(w,rt);ce(n.TEXTURE_CUBE_MAP,w);let te;if(w.isDepthTexture){if(bt=f(w.format===ws,w.type),Qt)if(Wt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,rt.width,rt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt.width,rt.height,0,Et,xt,null)}else if(mt){Wt&&Qt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,bt,rt.width,rt.height);for(let Ct=0;Ct<6;Ct++){te=at[Ct].mipmaps;for(let ue=0;ue<te.length;ue++){let Ve=te[ue];w.format!==Vi?Et!==null?Wt?ut&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,0,0,Ve.width,Ve.height,Et,Ve.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,bt,Ve.width,Ve.height,0,Ve.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,0,0,Ve.width,Ve.height,Et,xt,Ve.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,bt,Ve.width,Ve.height,0,Et,xt,Ve.data)}}}else{if(te=w.mipmaps,Wt&&Qt){te.length>0&&kt++;let Ct=Yt(at[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(z){Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,at[Ct].width,at[Ct].height,Et,xt,at[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,at[Ct].width,at[Ct].height,0,Et,xt,at[Ct].data);for(let ue=0;ue<te.length;ue++){let Bn=te[ue].image[Ct].image;Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,0,0,Bn.width,Bn.height,Et,xt,Bn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,bt,Bn.width,Bn.height,0,Et,xt,Bn.data)}}else{Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,xt,at[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,Et,xt,at[Ct]);for(let ue=0;ue<te.length;ue++){let Ve=te[ue];Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,0,0,Et,xt,Ve.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,bt,Et,xt,Ve.image[Ct])}}}C(w)&&w.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),yt.__version=lt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function Ne(L,w,Z,dt,lt,yt){let St=r.convert(Z.format,Z.colorSpace),st=r.convert(Z.type),ot=M(Z.internalFormat,St,st,Z.normalized,Z.colorSpace),mt=i.get(w),z=i.get(Z);if(z.__renderTarget=w,!mt.__hasExternalTextures){let at=Math.max(1,w.width>>yt),rt=Math.max(1,w.height>>yt);lt===n.TEXTURE_3D||lt===n.TEXTURE_2D_ARRAY?e.texImage3D(lt,yt,ot,at,rt,w.depth,0,St,st,null):e.texImage2D(lt,yt,ot,at,rt,0,St,st,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,dt,lt,z.__webglTexture,0,oe(w)):(lt===n.TEXTURE_2D||lt>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&lt<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,dt,lt,z.__webglTexture,yt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Sn(L,w,Z){if(n.bindRenderbuffer(n.RENDERBUFFER,L),w.depthBuffer){let dt=w.depthTexture,lt=dt&&dt.isDepthTexture?dt.type:null,yt=f(w.stencilBuffer,lt),St=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,oe(w),yt,w.width,w.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,oe(w),yt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,yt,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,L)}else{let dt=w.textures;for(let lt=0;lt<dt.length;lt++){let yt=dt[lt],St=r.convert(yt.format,yt.colorSpace),st=r.convert(yt.type),ot=M(yt.internalFormat,St,st,yt.normalized,yt.colorSpace);wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,oe(w),ot,w.width,w.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,oe(w),ot,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ot,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ve(L,w,Z){let dt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let lt=i.get(w.depthTexture);lt.__renderTarget=w;let yt=dt?w.depthTexture.image[0]:w.depthTexture.image;(!lt.__webglTexture||yt.width!==w.width||yt.height!==w.height)&&(yt.width=w.width,yt.height=w.height,w.depthTexture.needsUpdate=!0),dt?_t(w.depthTexture,0):ft(w.depthTexture,0);let St=lt.__webglTexture,st=oe(w),ot=dt?n.TEXTURE_CUBE_MAP_POSITIVE_X+Z:n.TEXTURE_2D,mt=w.depthTexture.format===ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===vs)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ot,St,0,st):n.framebufferTexture2D(n.FRAMEBUFFER,mt,ot,St,0);else if(w.depthTexture.format===ws)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ot,St,0,st):n.framebufferTexture2D(n.FRAMEBUFFER,mt,ot,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pn(L){let w=i.get(L),Z=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){let dt=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),dt){let lt=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,dt.removeEventListener("dispose",lt)};dt.addEventListener("dispose",lt),w.__depthDisposeCallback=lt}w.__boundDepthTexture=dt}if(L.depthTexture&&!w.__autoAllocateDepthBuffer)if(Z)for(let dt=0;dt<6;dt++)ve(w.__webglFramebuffer[dt],L,dt);else L.texture.mipmaps.length>0?ve(w.__webglFramebuffer[0],L,0):ve(w.__webglFramebuffer,L,0);else if(Z){w.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[dt]),w.__webglDepthbuffer[dt]===void 0)w.__webglDepthbuffer[dt]=n.createRenderbuffer(),Sn(w.__webglDepthbuffer[dt],L,!1);else{let lt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=w.__webglDepthbuffer[dt];n.bindRenderbuffer(n.RENDERBUFFER,yt),n.framebufferRenderbuffer(n.FRAMEBUFFER,lt,n.RENDERBUFFER,yt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Sn(w.__webglDepthbuffer,L,!1);else{let lt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,yt),n.framebufferRenderbuffer(n.FRAMEBUFFER,lt,n.RENDERBUFFER,yt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Je(L,w,Z){let dt=i.get(L);w!==void 0&&Ne(dt.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Z!==void 0&&pn(L)}function rn(L){let w=L.texture,Z=i.get(L),dt=i.get(w);L.addEventListener("dispose",U),I(L);let lt=L.textures,yt=L.isWebGLCubeRenderTarget===!0,St=lt.length>1;if(St||(dt.__webglTexture===void 0&&(dt.__webglTexture=n.createTexture()),dt.__version=w.version,o.memory.textures++),yt){Z.__webglFramebuffer=[];for(let st=0;st<6;st++)if(w.mipmaps.length>0){Z.__webglFramebuffer[st]=[];for(let ot=0;ot<w.mipmaps.length;ot++)Z.__webglFramebuffer[st][ot]=n.createFramebuffer()}else Z.__webglFramebuffer[st]=n.createFramebuffer()}else{if(w.mipmaps.length>0){Z.__webglFramebuffer=[];for(let st=0;st<w.mipmaps.length;st++)Z.__webglFramebuffer[st]=n.createFramebuffer()}else Z.__webglFramebuffer=n.createFramebuffer();if(St)for(let st=0,ot=lt.length;st<ot;st++){let mt=i.get(lt[st]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&wt(L)===!1){Z.__webglMultisampledFramebuffer=n.createFramebuffer(),Z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let st=0;st<lt.length;st++){let ot=lt[st];Z.__webglColorRenderbuffer[st]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Z.__webglColorRenderbuffer[st]);let mt=r.convert(ot.format,ot.colorSpace),z=r.convert(ot.type),at=M(ot.internalFormat,mt,z,ot.normalized,ot.colorSpace,L.isXRRenderTarget===!0),rt=oe(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,rt,at,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+st,n.RENDERBUFFER,Z.__webglColorRenderbuffer[st])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&(Z.__webglDepthRenderbuffer=n.createRenderbuffer(),Sn(Z.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(yt){e.bindTexture(n.TEXTURE_CUBE_MAP,dt.__webglTexture),ce(n.TEXTURE_CUBE_MAP,w);for(let st=0;st<6;st++)if(w.mipmaps.length>0)for(let ot=0;ot<w.mipmaps.length;ot++)Ne(Z.__webglFramebuffer[st][ot],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+st,ot);else Ne(Z.__webglFramebuffer[st],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+st,0);C(w)?b(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(St){for(let st=0,ot=lt.length;st<ot;st++){let mt=lt[st],z=i.get(mt),at=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(at=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(at,z.__webglTexture),ce(at,mt),Ne(Z.__webglFramebuffer,L,mt,n.COLOR_ATTACHMENT0+st,at,0),C(mt)&&b(at)}e.unbindTexture()}else{let st=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(st=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(st,dt.__webglTexture),ce(st,w),w.mipmaps.length>0)for(let ot=0;ot<w.mipmaps.length;ot++)Ne(Z.__webglFramebuffer[ot],L,w,n.COLOR_ATTACHMENT0,st,ot);else Ne(Z.__webglFramebuffer,L,w,n.COLOR_ATTACHMENT0,st,0);C(w)?b(st):w.mipmaps.length>0&&n.texParameteri(st,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&pn(L)}function V(L){let w=L.textures;for(let Z=0,dt=w.length;Z<dt;Z++){let lt=w[Z];if(C(lt)&&lt.mipmapsAutoUpdate===!0){let yt=A(L),St=i.get(lt).__webglTexture;e.bindTexture(yt,St),b(yt),e.unbindTexture()}}}let Rt=[];function Zt(L){if(L.samples>0){if(wt(L)===!1){let w=L.textures,Z=L.width,dt=L.height,lt=n.COLOR_BUFFER_BIT,yt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(L),st=w.length>1;if(st)for(let mt=0;mt<w.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let mt=0;mt<w.length;mt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(lt|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(lt|=n.STENCIL_BUFFER_BIT)),st){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[mt]);let z=i.get(w[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,Z,dt,0,0,Z,dt,lt,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Rt.push(yt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),st)for(let mt=0;mt<w.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,St.__webglColorRenderbuffer[mt]);let z=i.get(w[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let w=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function oe(L){return Math.min(s.maxSamples,L.samples)}function wt(L){let w=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Fe(L){let w=o.render.frame;u.get(L)!==w&&(u.set(L,w),L.update())}function Ht(L,w){let Z=L.colorSpace,dt=L.format,lt=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Z!==ua&&Z!==Es&&(ye.getTransfer(Z)===Ce?(dt!==Vi||lt!==ei)&&$t("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",Z)),w}function Yt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=et,this.resetTextureUnits=K,this.getTextureUnits=tt,this.setTextureUnits=ht,this.setTexture2D=ft,this.setTexture2DArray=gt,this.setTexture3D=vt,this.setTextureCube=_t,this.rebindTextures=Je,this.setupRenderTarget=rn,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Zt,this.setupDepthRenderbuffer=pn,this.setupFrameBufferTexture=Ne,this.useMultisampledRTT=wt,this.dispose=k}function uw(n,t){function e(i,s=Es){let r,o=ye.getTransfer(s);if(i===ei)return n.UNSIGNED_BYTE;if(i===Oc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Bc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Md)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===bd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===vd)return n.BYTE;if(i===Sd)return n.SHORT;if(i===Co)return n.UNSIGNED_SHORT;if(i===Fc)return n.INT;if(i===Bi)return n.UNSIGNED_INT;if(i===ki)return n.FLOAT;if(i===zi)return n.HALF_FLOAT;if(i===wd)return n.ALPHA;if(i===Ed)return n.RGB;if(i===Vi)return n.RGBA;if(i===vs)return n.DEPTH_COMPONENT;if(i===ws)return n.DEPTH_STENCIL;if(i===Td)return n.RED;if(i===kc)return n.RED_INTEGER;if(i===js)return n.RG;if(i===zc)return n.RG_INTEGER;if(i===Vc)return n.RGBA_INTEGER;if(i===Va||i===Ga||i===Ha||i===Wa)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Va)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Va)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ga)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ha)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Wa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Gc||i===Hc||i===Wc||i===Xc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Gc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Hc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Wc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Xc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===qc||i===Yc||i===$c||i===Zc||i===Jc||i===Xa||i===jc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===qc||i===Yc)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===$c)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Zc)return r.COMPRESSED_R11_EAC;if(i===Jc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Xa)return r.COMPRESSED_RG11_EAC;if(i===jc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Kc||i===Qc||i===th||i===eh||i===nh||i===ih||i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===hh||i===uh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Kc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Qc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===th)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===eh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===nh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ih)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===sh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===rh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===oh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ah)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===lh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ch)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===hh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===uh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===dh||i===fh||i===ph)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===dh)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===fh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ph)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===mh||i===gh||i===qa||i===_h)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===mh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===gh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===qa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===_h)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===br?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var dw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,fw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Qd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new wa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new bi({vertexShader:dw,fragmentShader:fw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Fn(new yr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},tf=class extends Ui{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,p=null,_=null,x=typeof XRWebGLBinding<"u",g=new Qd,m={},y=e.getContextAttributes(),C=null,b=null,A=[],M=[],f=new Jt,S=null,I=null,R=new qn;R.viewport=new Re;let P=new qn;P.viewport=new Re;let U=[R,P],B=new Ic,D=null,k=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let ft=A[$];return ft===void 0&&(ft=new vo,A[$]=ft),ft.getTargetRaySpace()},this.getControllerGrip=function($){let ft=A[$];return ft===void 0&&(ft=new vo,A[$]=ft),ft.getGripSpace()},this.getHand=function($){let ft=A[$];return ft===void 0&&(ft=new vo,A[$]=ft),ft.getHandSpace()};function q($){let ft=M.indexOf($.inputSource);if(ft===-1)return;let gt=A[ft];gt!==void 0&&(gt.update($.inputSource,$.frame,c||o),gt.dispatchEvent({type:$.type,data:$.inputSource}))}function O(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",O),s.removeEventListener("inputsourceschange",it);for(let $=0;$<A.length;$++){let ft=M[$];ft!==null&&(M[$]=null,A[$].disconnect(ft))}D=null,k=null,g.reset();for(let $ in m)delete m[$];if(t.setRenderTarget(C),p=null,h=null,d=null,s=null,b=null,et.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(f.width,f.height,!1),I!==null){let $=I.camera;$.fov=I.fov,$.zoom=I.zoom,$.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){r=$,i.isPresenting===!0&&$t("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,i.isPresenting===!0&&$t("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return h!==null?h:p},this.getBinding=function(){return d===null&&x&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function($){if(s=$,s!==null){if(C=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",O),s.addEventListener("inputsourceschange",it),y.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(f),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,vt=null,_t=null;y.depth&&(_t=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=y.stencil?ws:vs,vt=y.stencil?br:Bi);let Ft={colorFormat:e.RGBA8,depthFormat:_t,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Ft),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),b=new pi(h.textureWidth,h.textureHeight,{format:Vi,type:ei,depthTexture:new Ms(h.textureWidth,h.textureHeight,vt,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let gt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),b=new pi(p.framebufferWidth,p.framebufferHeight,{format:Vi,type:ei,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),et.setContext(s),et.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function it($){for(let ft=0;ft<$.removed.length;ft++){let gt=$.removed[ft],vt=M.indexOf(gt);vt>=0&&(M[vt]=null,A[vt].disconnect(gt))}for(let ft=0;ft<$.added.length;ft++){let gt=$.added[ft],vt=M.indexOf(gt);if(vt===-1){for(let Ft=0;Ft<A.length;Ft++)if(Ft>=M.length){M.push(gt),vt=Ft;break}else if(M[Ft]===null){M[Ft]=gt,vt=Ft;break}if(vt===-1)break}let _t=A[vt];_t&&_t.connect(gt)}}function Y($,ft){ft===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(ft.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(s===null)return;let ft=$.near,gt=$.far;g.texture!==null&&(g.depthNear>0&&(ft=g.depthNear),g.depthFar>0&&(gt=g.depthFar)),B.near=P.near=R.near=ft,B.far=P.far=R.far=gt,(D!==B.near||k!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),D=B.near,k=B.far),B.layers.mask=$.layers.mask|6,R.layers.mask=B.layers.mask&-5,P.layers.mask=B.layers.mask&-3;let vt=$.parent,_t=B.cameras;Y(B,vt);for(let Ft=0;Ft<_t.length;Ft++)Y(_t[Ft],vt);B.projectionMatrix.copy(R.projectionMatrix),B.projectionMatrixInverse.copy(R.projectionMatrixInverse),I===null&&$.isPerspectiveCamera&&(I={camera:$,fov:$.fov,zoom:$.zoom}),K($,B,vt)};function K($,ft,gt){gt===null?$.matrix.copy(ft.matrixWorld):($.matrix.copy(gt.matrixWorld),$.matrix.invert(),$.matrix.multiply(ft.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(ft.projectionMatrix),$.projectionMatrixInverse.copy(ft.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=xo*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(h===null&&p===null))return l},this.setFoveation=function($){l=$,h!==null&&(h.fixedFoveation=$),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function($){return m[$]};let tt=null;function ht($,ft){if(u=ft.getViewerPose(c||o),_=ft,u!==null){let gt=u.views;p!==null&&(t.setRenderTargetFramebuffer(b,p.framebuffer),t.setRenderTarget(b));let vt=!1;gt.length!==B.cameras.length&&(B.cameras.length=0,vt=!0);for(let Ot=0;Ot<gt.length;Ot++){let ce=gt[Ot],he=null;if(p!==null)he=p.getViewport(ce);else{let Ye=d.getViewSubImage(h,ce);he=Ye.viewport,Ot===0&&(t.setRenderTargetTextures(b,Ye.colorTexture,Ye.depthStencilTexture),t.setRenderTarget(b))}let Kt=U[Ot];Kt===void 0&&(Kt=new qn,Kt.layers.enable(Ot),Kt.viewport=new Re,U[Ot]=Kt),Kt.matrix.fromArray(ce.transform.matrix),Kt.matrix.decompose(Kt.position,Kt.quaternion,Kt.scale),Kt.projectionMatrix.fromArray(ce.projectionMatrix),Kt.projectionMatrixInverse.copy(Kt.projectionMatrix).invert(),Kt.viewport.set(he.x,he.y,he.width,he.height),Ot===0&&(B.matrix.copy(Kt.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),vt===!0&&B.cameras.push(Kt)}let _t=s.enabledFeatures;if(_t&&_t.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){d=i.getBinding();let Ot=d.getDepthInformation(gt[0]);Ot&&Ot.isValid&&Ot.texture&&g.init(Ot,s.renderState)}if(_t&&_t.includes("camera-access")&&x){t.state.unbindTexture(),d=i.getBinding();for(let Ot=0;Ot<gt.length;Ot++){let ce=gt[Ot].camera;if(ce){let he=m[ce];he||(he=new wa,m[ce]=he);let Kt=d.getCameraImage(ce);he.sourceTexture=Kt}}}}for(let gt=0;gt<A.length;gt++){let vt=M[gt],_t=A[gt];vt!==null&&_t!==void 0&&_t.update(vt,ft,c||o)}tt&&tt($,ft),ft.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ft}),_=null}let et=new p0;et.setAnimationLoop(ht),this.setAnimationLoop=function($){tt=$},this.dispose=function(){}}},pw=new De,w0=new se;w0.set(-1,0,0,0,1,0,0,0,1);function mw(n,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Fd(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,C,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),d(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&p(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),_(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,y,C):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===jn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===jn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=t.get(m),C=y.envMap,b=y.envMapRotation;C&&(g.envMap.value=C,g.envMapRotation.value.setFromMatrix4(pw.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(w0),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,y,C){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=C*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function d(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function p(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===jn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function _(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let y=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function gw(n,t,e,i){let s={},r={};function o(y,C){let b=C.program;i.uniformBlockBinding(y,b,s[y.id])}function a(y,C){let b=s[y.id];b===void 0&&(_(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",g));let A=C.program;i.updateUBOMapping(y,A);let M=t.render.frame;r[y.id]!==M&&(c(y),r[y.id]=M)}function l(y){let C=n.createBuffer(),b=y.__size,A=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,b,A),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(y){let C=s[y.id],b=y.uniforms,A=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let M=0,f=b.length;M<f;M++){let S=b[M];if(Array.isArray(S))for(let I=0,R=S.length;I<R;I++)u(S[I],M,I,A);else u(S,M,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,C,b,A){if(h(y,C,b,A)===!0){let M=y.__offset,f=y.value;if(Array.isArray(f)){let S=0;for(let I=0;I<f.length;I++){let R=f[I],P=x(R,!0);d(R,y.__data,S),S+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else d(f,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,y.__data)}}function d(y,C,b){typeof y=="number"||typeof y=="boolean"?C[b]=y:y.isMatrix3?(C[b]=y.elements[0],C[b+1]=y.elements[1],C[b+2]=y.elements[2],C[b+3]=0,C[b+4]=y.elements[3],C[b+5]=y.elements[4],C[b+6]=y.elements[5],C[b+7]=0,C[b+8]=y.elements[6],C[b+9]=y.elements[7],C[b+10]=y.elements[8],C[b+11]=0):ArrayBuffer.isView(y)?C.set(y.subarray(0,C.length-b),b):y.toArray(C,b)}function h(y,C,b,A){let M=y.value,f=C+"_"+b;if(Array.isArray(M)){A[f]===void 0&&(A[f]=[]);let S=A[f],I=!1;for(let R=0;R<M.length;R++)p(M[R],S,R)===!0&&(I=!0);return I}return p(M,A,f)}function p(y,C,b){if(C[b]===void 0)return typeof y=="number"||typeof y=="boolean"?C[b]=y:ArrayBuffer.isView(y)?C[b]=y.slice():C[b]=y.clone(),!0;{let A=C[b];if(typeof y=="number"||typeof y=="boolean"){if(A!==y)return C[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(A.equals(y)===!1)return A.copy(y),!0}}return!1}function _(y){let C=y.uniforms,b=0,A=16;for(let f=0,S=C.length;f<S;f++){let I=Array.isArray(C[f])?C[f]:[C[f]];for(let R=0,P=I.length;R<P;R++){let U=I[R],B=Array.isArray(U.value)?U.value:[U.value],D=Array.isArray(C[f])||Array.isArray(U.value),k=b;for(let O=0,it=B.length;O<it;O++){let Y=B[O],K=x(Y,D),tt=b%A,ht=tt%K.boundary,et=tt+ht;b+=ht,et!==0&&A-et<K.storage&&(b+=A-et),O===0&&(k=b),b+=K.storage}let q=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new q((b-k)/Float32Array.BYTES_PER_ELEMENT),U.__offset=k}}let M=b%A;return M>0&&(b+=A-M),y.__size=b,y.__cache={},this}function x(y,C){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?$t("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):$t("WebGLRenderer: Unsupported uniform value type.",y),C===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let C=y.target;C.removeEventListener("dispose",g),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var _w=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function xw(){return is===null&&(is=new uc(_w,16,16,js,zi),is.name="DFG_LUT",is.minFilter=$n,is.magFilter=$n,is.wrapS=Qi,is.wrapT=Qi,is.generateMipmaps=!1,is.needsUpdate=!0),is}var bh=class{constructor(t={}){let{canvas:e=zg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:p=ei}=t;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let x=p,g=new Set([Vc,zc,kc]),m=new Set([ei,Bi,Co,br,Oc,Bc]),y=new Uint32Array(4),C=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,M=null,f=[],S=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,P=!1,U=null,B=null,D=null,k=null;this._outputColorSpace=Xn;let q=0,O=0,it=null,Y=-1,K=null,tt=new Re,ht=new Re,et=null,$=new le(0),ft=0,gt=e.width,vt=e.height,_t=1,Ft=null,qt=null,Ot=new Re(0,0,gt,vt),ce=new Re(0,0,gt,vt),he=!1,Kt=new Gs,Ye=new dc,ke=!1,sn=!1,Ne=new De,Sn=new X,ve=new Re,pn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Je=!1;function rn(){return it===null?_t:1}let V=i;function Rt(T,G){return e.getContext(T,G)}let Zt,oe,wt,Fe,Ht,Yt,L,w,Z,dt,lt,yt,St,st,ot,mt,z,at,rt,Et,xt,bt,Wt;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),V===null){let G="webgl2";if(V=Rt(G,T),V===null)throw Rt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qt()}catch(T){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ie("WebGLRenderer: "+T.message),T}function Qt(){Zt=new Rb(V),Zt.init(),xt=new uw(V,Zt),oe=new xb(V,Zt,t,xt),wt=new cw(V,Zt),oe.reversedDepthBuffer&&h&&wt.buffers.depth.setReversed(!0),B=V.createFramebuffer(),D=V.createFramebuffer(),k=V.createFramebuffer(),Fe=new Lb(V),Ht=new Z1,Yt=new hw(V,Zt,wt,Ht,oe,xt,Fe),L=new Cb(R),w=new Nv(V),bt=new gb(V,w),Z=new Pb(V,w,Fe,bt),dt=new Nb(V,Z,w,bt,Fe),at=new Db(V,oe,Yt),ot=new yb(Ht),lt=new $1(R,L,Zt,oe,bt,ot),yt=new mw(R,Ht),St=new j1,st=new iw(Zt),z=new mb(R,L,wt,dt,_,l),mt=new lw(R,dt,oe),Wt=new gw(V,Fe,oe,wt),rt=new _b(V,Zt,Fe),Et=new Ib(V,Zt,Fe),Fe.programs=lt.programs,R.capabilities=oe,R.extensions=Zt,R.properties=Ht,R.renderLists=St,R.shadowMap=mt,R.state=wt,R.info=Fe}x!==ei&&(I=new Fb(x,e.width,e.height,a,s,r));let ut=new tf(R,V);this.xr=ut,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let T=Zt.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Zt.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return _t},this.setPixelRatio=function(T){T!==void 0&&(_t=T,this.setSize(gt,vt,!1))},this.getSize=function(T){return T.set(gt,vt)},this.setSize=function(T,G,nt=!0){if(ut.isPresenting){$t("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=T,vt=G,e.width=Math.floor(T*_t),e.height=Math.floor(G*_t),nt===!0&&(e.style.width=T+"px",e.style.height=G+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,T,G)},this.getDrawingBufferSize=function(T){return T.set(gt*_t,vt*_t).floor()},this.setDrawingBufferSize=function(T,G,nt){gt=T,vt=G,_t=nt,e.width=Math.floor(T*nt),e.height=Math.floor(G*nt),this.setViewport(0,0,T,G)},this.setEffects=function(T){if(x===ei){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let G=0;G<T.length;G++)if(T[G].isOutputPass===!0){$t("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(tt)},this.getViewport=function(T){return T.copy(Ot)},this.setViewport=function(T,G,nt,J){T.isVector4?Ot.set(T.x,T.y,T.z,T.w):Ot.set(T,G,nt,J),wt.viewport(tt.copy(Ot).multiplyScalar(rn()).round())},this.getScissor=function(T){return T.copy(ce)},this.setScissor=function(T,G,nt,J){T.isVector4?ce.set(T.x,T.y,T.z,T.w):ce.set(T,G,nt,J),wt.scissor(ht.copy(ce).multiplyScalar(rn()).round())},this.getScissorTest=function(){return he},this.setScissorTest=function(T){wt.setScissorTest(he=T)},this.setOpaqueSort=function(T){Ft=T},this.setTransparentSort=function(T){qt=T},this.getClearColor=function(T){return T.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(T=!0,G=!0,nt=!0){let J=0;if(T){let j=!1;if(it!==null){let Tt=it.texture.format;j=g.has(Tt)}if(j){let Tt=it.texture.type,It=m.has(Tt),At=z.getClearColor(),Lt=z.getClearAlpha(),Vt=At.r,ee=At.g,pe=At.b;It?(y[0]=Vt,y[1]=ee,y[2]=pe,y[3]=Lt,V.clearBufferuiv(V.COLOR,0,y)):(C[0]=Vt,C[1]=ee,C[2]=pe,C[3]=Lt,V.clearBufferiv(V.COLOR,0,C))}else J|=V.COLOR_BUFFER_BIT}G&&(J|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),nt&&(J|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&V.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),U=T},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),z.dispose(),St.dispose(),st.dispose(),Yt.dispose(),Ht.dispose(),L.dispose(),dt.dispose(),Z.dispose(),bt.dispose(),Wt.dispose(),lt.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",nl),ut.removeEventListener("sessionend",Gi),as.stop()};function kt(T){T.preventDefault(),pa("WebGLRenderer: Context Lost."),P=!0}function te(){pa("WebGLRenderer: Context Restored."),P=!1;let T=Fe.autoReset,G=mt.enabled,nt=mt.autoUpdate,J=mt.needsUpdate,j=mt.type;Qt(),Fe.autoReset=T,mt.enabled=G,mt.autoUpdate=nt,mt.needsUpdate=J,mt.type=j}function Ct(T){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ue(T){let G=T.target;G.removeEventListener("dispose",ue),Ve(G)}function Ve(T){Bn(T),Ht.remove(T)}function Bn(T){let G=Ht.get(T).programs;G!==void 0&&(G.forEach(function(nt){lt.releaseProgram(nt)}),T.isShaderMaterial&&lt.releaseShaderCache(T))}this.renderBufferDirect=function(T,G,nt,J,j,Tt){G===null&&(G=pn);let It=j.isMesh&&j.matrixWorld.determinantAffine()<0,At=Bo(T,G,nt,J,j);wt.setMaterial(J,It);let Lt=nt.index,Vt=1;if(J.wireframe===!0){if(Lt=Z.getWireframeAttribute(nt),Lt===void 0)return;Vt=2}let ee=nt.drawRange,pe=nt.attributes.position,zt=ee.start*Vt,me=(ee.start+ee.count)*Vt;Tt!==null&&(zt=Math.max(zt,Tt.start*Vt),me=Math.min(me,(Tt.start+Tt.count)*Vt)),Lt!==null?(zt=Math.max(zt,0),me=Math.min(me,Lt.count)):pe!=null&&(zt=Math.max(zt,0),me=Math.min(me,pe.count));let Ze=me-zt;if(Ze<0||Ze===1/0)return;bt.setup(j,J,At,nt,Lt);let Pe,Ie=rt;if(Lt!==null&&(Pe=w.get(Lt),Ie=Et,Ie.setIndex(Pe)),j.isMesh)J.wireframe===!0?(wt.setLineWidth(J.wireframeLinewidth*rn()),Ie.setMode(V.LINES)):Ie.setMode(V.TRIANGLES);else if(j.isLine){let mn=J.linewidth;mn===void 0&&(mn=1),wt.setLineWidth(mn*rn()),j.isLineSegments?Ie.setMode(V.LINES):j.isLineLoop?Ie.setMode(V.LINE_LOOP):Ie.setMode(V.LINE_STRIP)}else j.isPoints?Ie.setMode(V.POINTS):j.isSprite&&Ie.setMode(V.TRIANGLES);if(j.isBatchedMesh)if(Zt.get("WEBGL_multi_draw"))Ie.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let mn=j._multiDrawStarts,Ut=j._multiDrawCounts,on=j._multiDrawCount,_e=Lt?w.get(Lt).bytesPerElement:1,cs=Ht.get(J).currentProgram.getUniforms();for(let an=0;an<on;an++)cs.setValue(V,"_gl_DrawID",an),Ie.render(mn[an]/_e,Ut[an])}else if(j.isInstancedMesh)Ie.renderInstances(zt,Ze,j.count);else if(nt.isInstancedBufferGeometry){let mn=nt._maxInstanceCount!==void 0?nt._maxInstanceCount:1/0,Ut=Math.min(nt.instanceCount,mn);Ie.renderInstances(zt,Ze,Ut)}else Ie.render(zt,Ze)};function Uo(T,G,nt,J){U!==null&&T.isNodeMaterial&&U.setObject(J,T),ke===!0&&ot.setState(T,nt,!1),T.transparent===!0&&T.side===es&&T.forceSinglePass===!1?(T.side=jn,T.needsUpdate=!0,Hi(T,G,J),T.side=Js,T.needsUpdate=!0,Hi(T,G,J),T.side=es):Hi(T,G,J)}this.compile=function(T,G,nt=null){nt===null&&(nt=T),U!==null&&U.renderStart(T,G,nt),M=st.get(nt),M.init(G),S.push(M),nt.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),T!==nt&&T.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),M.setupLights(),U!==null&&U.updateLights(M.state.lightsArray),sn=this.localClippingEnabled,ke=ot.init(this.clippingPlanes,sn),ke===!0&&ot.setGlobalState(this.clippingPlanes,G),U!==null&&mt.render(M.state.shadowsArray,nt,G);let J=new Set;return T.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Tt=j.material;if(Tt)if(Array.isArray(Tt))for(let It=0;It<Tt.length;It++){let At=Tt[It];Uo(At,nt,G,j),J.add(At)}else Uo(Tt,nt,G,j),J.add(Tt)}),M=S.pop(),U!==null&&U.renderEnd(),J},this.compileAsync=function(T,G,nt=null){let J=this.compile(T,G,nt);return new Promise(j=>{function Tt(){if(J.forEach(function(It){let Lt=Ht.get(It).currentProgram;(Lt===void 0||Lt.isReady())&&J.delete(It)}),J.size===0){j(T);return}setTimeout(Tt,10)}Zt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Cr=null;function Uh(T){Cr&&Cr(T)}function nl(){as.stop()}function Gi(){as.start()}let as=new p0;as.setAnimationLoop(Uh),typeof self<"u"&&as.setContext(self),this.setAnimationLoop=function(T){Cr=T,ut.setAnimationLoop(T),T===null?as.stop():as.start()},ut.addEventListener("sessionstart",nl),ut.addEventListener("sessionend",Gi),this.render=function(T,G){if(G!==void 0&&G.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;U!==null&&U.renderStart(T,G);let nt=ut.enabled===!0&&ut.isPresenting===!0,J=I!==null&&(it===null||nt)&&I.begin(R,it);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(G),G=ut.getCamera()),T.isScene===!0&&T.onBeforeRender(R,T,G,it),M=st.get(T,S.length),M.init(G),M.state.textureUnits=Yt.getTextureUnits(),S.push(M),Ne.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Ye.setFromArrayCamera(G):Kt.setFromProjectionMatrix(Ne,Mi,G.reversedDepth),sn=this.localClippingEnabled,ke=ot.init(this.clippingPlanes,sn),A=St.get(T,f.length),A.init(),f.push(A),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let It=R.xr.getDepthSensingMesh();It!==null&&ls(It,G,-1/0,R.sortObjects)}ls(T,G,0,R.sortObjects),A.finish(),U!==null&&U.updateLights(M.state.lightsArray),R.sortObjects===!0&&A.sort(Ft,qt),Je=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Je&&z.addToRenderList(A,T),this.info.autoReset===!0&&this.info.reset(),ke===!0&&ot.beginShadows();let j=M.state.shadowsArray;if(mt.render(j,T,G),ke===!0&&ot.endShadows(),(J&&I.hasRenderPass())===!1){let It=A.opaque,At=A.transmissive;if(M.setupLights(),G.isArrayCamera){let Lt=G.cameras;if(At.length>0)for(let Vt=0,ee=Lt.length;Vt<ee;Vt++){let pe=Lt[Vt];wi(It,At,T,pe)}Je&&z.render(T);for(let Vt=0,ee=Lt.length;Vt<ee;Vt++){let pe=Lt[Vt];Fo(A,T,pe,pe.viewport)}}else At.length>0&&wi(It,At,T,G),Je&&z.render(T),Fo(A,T,G)}it!==null&&O===0&&(Yt.updateMultisampleRenderTarget(it),Yt.updateRenderTargetMipmap(it)),J&&I.end(R),T.isScene===!0&&T.onAfterRender(R,T,G),bt.resetDefaultState(),Y=-1,K=null,S.pop(),S.length>0?(M=S[S.length-1],Yt.setTextureUnits(M.state.textureUnits),ke===!0&&ot.setGlobalState(R.clippingPlanes,M.state.camera)):M=null,f.pop(),f.length>0?A=f[f.length-1]:A=null,U!==null&&U.renderEnd()};function ls(T,G,nt,J){if(T.visible===!1)return;if(T.layers.test(G.layers)){if(T.isGroup)nt=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(G);else if(T.isLight)M.pushLight(T),T.castShadow&&M.pushShadow(T);else if(T.isSprite){let It=G.isArrayCamera?Ye:Kt;if(!T.frustumCulled||T.intersectsFrustum(It)){J&&ve.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ne);let At=dt.update(T),Lt=T.material;Lt.visible&&A.push(T,At,Lt,nt,ve.z,null,G)}}else if(T.isMesh||T.isLine||T.isPoints){let It=G.isArrayCamera?Ye:Kt;if(!T.frustumCulled||T.intersectsFrustum(It)){let At=dt.update(T),Lt=T.material;if(J&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ve.copy(T.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),ve.copy(At.boundingSphere.center)),ve.applyMatrix4(T.matrixWorld).applyMatrix4(Ne)),Array.isArray(Lt)){let Vt=At.groups;for(let ee=0,pe=Vt.length;ee<pe;ee++){let zt=Vt[ee],me=Lt[zt.materialIndex];me&&me.visible&&A.push(T,At,me,nt,ve.z,zt,G)}}else Lt.visible&&A.push(T,At,Lt,nt,ve.z,null,G)}}}let Tt=T.children;for(let It=0,At=Tt.length;It<At;It++)ls(Tt[It],G,nt,J)}function Fo(T,G,nt,J){let{opaque:j,transmissive:Tt,transparent:It}=T;M.setupLightsView(nt),ke===!0&&ot.setGlobalState(R.clippingPlanes,nt),J&&wt.viewport(tt.copy(J)),j.length>0&&je(j,G,nt),Tt.length>0&&je(Tt,G,nt),It.length>0&&je(It,G,nt),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function wi(T,G,nt,J){if((nt.isScene===!0?nt.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[J.id]===void 0){let zt=Zt.has("EXT_color_buffer_half_float")||Zt.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[J.id]=new pi(1,1,{generateMipmaps:!0,type:zt?zi:ei,minFilter:bs,samples:Math.max(4,oe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ye.workingColorSpace})}let Tt=M.state.transmissionRenderTarget[J.id],It=J.viewport||tt;Tt.setSize(It.z*R.transmissionResolutionScale,It.w*R.transmissionResolutionScale);let At=R.getRenderTarget(),Lt=R.getActiveCubeFace(),Vt=R.getActiveMipmapLevel();R.setRenderTarget(Tt),R.getClearColor($),ft=R.getClearAlpha(),ft<1&&R.setClearColor(16777215,.5),R.clear(),Je&&z.render(nt);let ee=R.toneMapping;R.toneMapping=ns;let pe=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),M.setupLightsView(J),ke===!0&&ot.setGlobalState(R.clippingPlanes,J),je(T,nt,J),Yt.updateMultisampleRenderTarget(Tt),Yt.updateRenderTargetMipmap(Tt),Zt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let me=0,Ze=G.length;me<Ze;me++){let Pe=G[me],{object:Ie,geometry:mn,material:Ut,group:on}=Pe;if(Ut.side===es&&Ie.layers.test(J.layers)){let _e=Ut.side;Ut.side=jn,Ut.needsUpdate=!0,en(Ie,nt,J,mn,Ut,on),Ut.side=_e,Ut.needsUpdate=!0,zt=!0}}zt===!0&&(Yt.updateMultisampleRenderTarget(Tt),Yt.updateRenderTargetMipmap(Tt))}R.setRenderTarget(At,Lt,Vt),R.setClearColor($,ft),pe!==void 0&&(J.viewport=pe),R.toneMapping=ee}function je(T,G,nt){let J=G.isScene===!0?G.overrideMaterial:null;for(let j=0,Tt=T.length;j<Tt;j++){let It=T[j],{object:At,geometry:Lt,group:Vt}=It,ee=It.material;ee.allowOverride===!0&&J!==null&&(ee=J),At.layers.test(nt.layers)&&en(At,G,nt,Lt,ee,Vt)}}function en(T,G,nt,J,j,Tt){U!==null&&j.isNodeMaterial&&U.setObject(T,j),T.onBeforeRender(R,G,nt,J,j,Tt),T.modelViewMatrix.multiplyMatrices(nt.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),j.onBeforeRender(R,G,nt,J,T,Tt),j.transparent===!0&&j.side===es&&j.forceSinglePass===!1?(j.side=jn,j.needsUpdate=!0,R.renderBufferDirect(nt,G,J,j,T,Tt),j.side=Js,j.needsUpdate=!0,R.renderBufferDirect(nt,G,J,j,T,Tt),j.side=es):R.renderBufferDirect(nt,G,J,j,T,Tt),T.onAfterRender(R,G,nt,J,j,Tt)}function nn(T){let G=0;for(let nt of T)nt.texture!==null&&G++;return G}function Hi(T,G,nt){G.isScene!==!0&&(G=pn);let J=Ht.get(T),j=M.state.lights,Tt=M.state.shadowsArray,It=j.state.version,At=lt.getParameters(T,j.state,Tt,G,nt,M.state.lightProbeGridArray),Lt=lt.getProgramCacheKey(At),Vt=J.programs;J.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?G.environment:null,J.fog=G.fog;let ee=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;J.envMap=L.get(T.envMap||J.environment,ee),J.envMapRotation=J.environment!==null&&T.envMap===null?G.environmentRotation:T.envMapRotation,Vt===void 0&&(T.addEventListener("dispose",ue),Vt=new Map,J.programs=Vt,J.programVariants=new Map);let pe=Vt.get(Lt);if(pe!==void 0){if(J.currentProgram===pe&&J.lightsStateVersion===It)return Oo(T,At),pe}else At.uniforms=lt.getUniforms(T),U!==null&&T.isNodeMaterial&&U.build(T,nt,At),T.onBeforeCompile(At,R),pe=lt.acquireProgram(At,Lt),Vt.set(Lt,pe),J.uniforms=At.uniforms;let zt=J.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(zt.clippingPlanes=ot.uniform),Oo(T,At),J.needsLights=Cs(T),J.lightsStateVersion=It,J.needsLights&&(zt.ambientLightColor.value=j.state.ambient,zt.lightProbe.value=j.state.probe,zt.sunLights.value=j.state.sun,zt.sunLightShadows.value=j.state.sunShadow,zt.directionalLights.value=j.state.directional,zt.directionalLightShadows.value=j.state.directionalShadow,zt.spotLights.value=j.state.spot,zt.spotLightShadows.value=j.state.spotShadow,zt.rectAreaLights.value=j.state.rectArea,zt.ltc_1.value=j.state.rectAreaLTC1,zt.ltc_2.value=j.state.rectAreaLTC2,zt.pointLights.value=j.state.point,zt.pointLightShadows.value=j.state.pointShadow,zt.hemisphereLights.value=j.state.hemi,zt.sunShadowMatrix.value=j.state.sunShadowMatrix,zt.sunShadowCascade.value=j.state.sunShadowCascade,zt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,zt.spotLightMatrix.value=j.state.spotLightMatrix,zt.spotLightMap.value=j.state.spotLightMap,zt.pointShadowMatrix.value=j.state.pointShadowMatrix),J.numLightProbeGrids=nn(M.state.lightProbeGridArray),J.currentProgram=pe,J.uniformsList=null,pe}function ii(T,G,nt,J,j){let Tt=Ht.get(T),It=Tt.currentProgram.id+","+J+","+j,At=Tt.programVariants.get(It);return At===void 0?(At=Hi(T,G,nt),Tt.programVariants.set(It,At)):(Tt.currentProgram=At,Tt.uniformsList=null,Tt.outputColorSpace=J,Tt.toneMapping=j),At}function As(T){if(T.uniformsList===null){let G=T.currentProgram.getUniforms();T.uniformsList=Ro.seqWithValue(G.seq,T.uniforms)}return T.uniformsList}function Oo(T,G){let nt=Ht.get(T);nt.outputColorSpace=G.outputColorSpace,nt.batching=G.batching,nt.batchingColor=G.batchingColor,nt.instancing=G.instancing,nt.instancingColor=G.instancingColor,nt.instancingMorph=G.instancingMorph,nt.skinning=G.skinning,nt.morphTargets=G.morphTargets,nt.morphNormals=G.morphNormals,nt.morphColors=G.morphColors,nt.morphTargetsCount=G.morphTargetsCount,nt.numClippingPlanes=G.numClippingPlanes,nt.numIntersection=G.numClipIntersection,nt.vertexAlphas=G.vertexAlphas,nt.vertexTangents=G.vertexTangents,nt.toneMapping=G.toneMapping}function Bo(T,G,nt,J,j){G.isScene!==!0&&(G=pn),Yt.resetTextureUnits();let Tt=G.fog,It=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?G.environment:null,At=it===null?R.outputColorSpace:it.isXRRenderTarget===!0?it.texture.colorSpace:ye.workingColorSpace,Lt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Vt=L.get(J.envMap||It,Lt),ee=J.vertexColors===!0&&!!nt.attributes.color&&nt.attributes.color.itemSize===4,pe=!!nt.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),zt=!!nt.morphAttributes.position,me=!!nt.morphAttributes.normal,Ze=!!nt.morphAttributes.color,Pe=ns;J.toneMapped&&(it===null||it.isXRRenderTarget===!0)&&(Pe=R.toneMapping);let Ie=nt.morphAttributes.position||nt.morphAttributes.normal||nt.morphAttributes.color,mn=Ie!==void 0?Ie.length:0,Ut=Ht.get(J),on=M.state.lights;if(ke===!0&&(sn===!0||T!==K)){let Le=T===K&&J.id===Y;ot.setState(J,T,Le)}let _e=!1,cs=!1;J.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==on.state.version||j.isBatchedMesh&&Ut.batching===!1||!j.isBatchedMesh&&Ut.batching===!0||j.isBatchedMesh&&Ut.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Ut.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Ut.instancing===!1||!j.isInstancedMesh&&Ut.instancing===!0||j.isSkinnedMesh&&Ut.skinning===!1||!j.isSkinnedMesh&&Ut.skinning===!0||j.isInstancedMesh&&Ut.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Ut.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Ut.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Ut.instancingMorph===!1&&j.morphTexture!==null||Ut.envMap!==Vt||J.fog===!0&&Ut.fog!==Tt||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==ot.numPlanes||Ut.numIntersection!==ot.numIntersection)||Ut.vertexAlphas!==ee||Ut.vertexTangents!==pe||Ut.morphTargets!==zt||Ut.morphNormals!==me||Ut.morphColors!==Ze||Ut.morphTargetsCount!==mn||Ut.numLightProbeGrids!==nn(M.state.lightProbeGridArray)?_e=!0:(Ut.outputColorSpace!==At||Ut.toneMapping!==Pe)&&(cs=!0):(_e=!0,Ut.__version=J.version);let an=Ut.currentProgram;(_e===!0||cs===!0)&&(an=cs===!0?ii(J,G,j,At,Pe):Hi(J,G,j),U&&J.isNodeMaterial&&U.onUpdateProgram(J,an,Ut));let Ir=!1,Wi=!1,hs=!1,de=an.getUniforms(),Ke=Ut.uniforms;if(wt.useProgram(an.program)&&(Ir=!0,Wi=!0,hs=!0),J.id!==Y&&(Y=J.id,Wi=!0),Ir||K!==T){wt.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),de.setValue(V,"projectionMatrix",T.projectionMatrix),de.setValue(V,"viewMatrix",T.matrixWorldInverse);let ln=de.map.cameraPosition;ln!==void 0&&ln.setValue(V,Sn.setFromMatrixPosition(T.matrixWorld)),oe.logarithmicDepthBuffer&&de.setValue(V,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&de.setValue(V,"isOrthographic",T.isOrthographicCamera===!0),K!==T&&(K=T,Wi=!0,hs=!0)}if(Ut.needsLights&&(on.state.sunShadowMap.length>0&&de.setValue(V,"sunShadowMap",on.state.sunShadowMap,Yt),on.state.directionalShadowMap.length>0&&de.setValue(V,"directionalShadowMap",on.state.directionalShadowMap,Yt),on.state.spotShadowMap.length>0&&de.setValue(V,"spotShadowMap",on.state.spotShadowMap,Yt),on.state.pointShadowMap.length>0&&de.setValue(V,"pointShadowMap",on.state.pointShadowMap,Yt)),j.isSkinnedMesh){de.setOptional(V,j,"bindMatrix"),de.setOptional(V,j,"bindMatrixInverse");let Le=j.skeleton;Le&&(Le.boneTexture===null&&Le.computeBoneTexture(),de.setValue(V,"boneTexture",Le.boneTexture,Yt))}j.isBatchedMesh&&(de.setOptional(V,j,"batchingTexture"),de.setValue(V,"batchingTexture",j._matricesTexture,Yt),de.setOptional(V,j,"batchingIdTexture"),de.setValue(V,"batchingIdTexture",j._indirectTexture,Yt),de.setOptional(V,j,"batchingColorTexture"),j._colorsTexture!==null&&de.setValue(V,"batchingColorTexture",j._colorsTexture,Yt));let kn=nt.morphAttributes;if((kn.position!==void 0||kn.normal!==void 0||kn.color!==void 0)&&at.update(j,nt,an),(Wi||Ut.receiveShadow!==j.receiveShadow)&&(Ut.receiveShadow=j.receiveShadow,de.setValue(V,"receiveShadow",j.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&G.environment!==null&&(Ke.envMapIntensity.value=G.environmentIntensity),Ke.dfgLUT!==void 0&&(Ke.dfgLUT.value=xw()),Wi){if(de.setValue(V,"toneMappingExposure",R.toneMappingExposure),Ut.needsLights&&Rr(Ke,hs),Tt&&J.fog===!0&&yt.refreshFogUniforms(Ke,Tt),yt.refreshMaterialUniforms(Ke,J,_t,vt,M.state.transmissionRenderTarget[T.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Le=b,ln=0;for(let Dn of M.state.lightProbeGridArray)Dn.texture!==null&&(Le.textures[ln]=Dn.texture,Le.min[ln]=Dn.boundingBox.min,Le.max[ln]=Dn.boundingBox.max,Le.resolution[ln]=Dn.resolution,ln++);for(let Dn in Le)Le[Dn].length=ln;Ke.probesSH.value=Le.textures,Ke.probesMin.value=Le.min,Ke.probesMax.value=Le.max,Ke.probesResolution.value=Le.resolution}Ro.upload(V,As(Ut),Ke,Yt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Ro.upload(V,As(Ut),Ke,Yt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&de.setValue(V,"center",j.center),de.setValue(V,"modelViewMatrix",j.modelViewMatrix),de.setValue(V,"normalMatrix",j.normalMatrix),de.setValue(V,"modelMatrix",j.matrixWorld),J.uniformsGroups!==void 0){let Le=J.uniformsGroups;for(let ln=0,Dn=Le.length;ln<Dn;ln++){let il=Le[ln];Wt.update(il,an),Wt.bind(il,an)}}return an}function Rr(T,G){T.ambientLightColor.needsUpdate=G,T.lightProbe.needsUpdate=G,T.sunLights.needsUpdate=G,T.sunLightShadows.needsUpdate=G,T.directionalLights.needsUpdate=G,T.directionalLightShadows.needsUpdate=G,T.pointLights.needsUpdate=G,T.pointLightShadows.needsUpdate=G,T.spotLights.needsUpdate=G,T.spotLightShadows.needsUpdate=G,T.rectAreaLights.needsUpdate=G,T.hemisphereLights.needsUpdate=G}function Cs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return it},this.setRenderTargetTextures=function(T,G,nt){let J=Ht.get(T);J.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Ht.get(T.texture).__webglTexture=G,Ht.get(T.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:nt,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,G){let nt=Ht.get(T);nt.__webglFramebuffer=G,nt.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(T,G=0,nt=0){it=T,q=G,O=nt;let J=null,j=!1,Tt=!1;if(T){let At=Ht.get(T);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(V.FRAMEBUFFER,At.__webglFramebuffer),tt.copy(T.viewport),ht.copy(T.scissor),et=T.scissorTest,wt.viewport(tt),wt.scissor(ht),wt.setScissorTest(et),Y=-1;return}else if(At.__webglFramebuffer===void 0)Yt.setupRenderTarget(T);else if(At.__hasExternalTextures)Yt.rebindTextures(T,Ht.get(T.texture).__webglTexture,Ht.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let ee=T.depthTexture;if(At.__boundDepthTexture!==ee){if(ee!==null&&Ht.has(ee)&&(T.width!==ee.image.width||T.height!==ee.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Yt.setupDepthRenderbuffer(T)}}let Lt=T.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Tt=!0);let Vt=Ht.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Vt[G])?J=Vt[G][nt]:J=Vt[G],j=!0):T.samples>0&&Yt.useMultisampledRTT(T)===!1?J=Ht.get(T).__webglMultisampledFramebuffer:Array.isArray(Vt)?J=Vt[nt]:J=Vt,tt.copy(T.viewport),ht.copy(T.scissor),et=T.scissorTest}else tt.copy(Ot).multiplyScalar(_t).floor(),ht.copy(ce).multiplyScalar(_t).floor(),et=he;if(nt!==0&&(J=B),wt.bindFramebuffer(V.FRAMEBUFFER,J)&&wt.drawBuffers(T,J),wt.viewport(tt),wt.scissor(ht),wt.setScissorTest(et),j){let At=Ht.get(T.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+G,At.__webglTexture,nt)}else if(Tt){let At=G;for(let Lt=0;Lt<T.textures.length;Lt++){let Vt=Ht.get(T.textures[Lt]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Lt,Vt.__webglTexture,nt,At)}}else if(T!==null&&nt!==0){let At=Ht.get(T.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,At.__webglTexture,nt)}Y=-1};function Pr(T){let G=Ht.get(T);return(G.__readFormat!==T.format||G.__readType!==T.type)&&(G.__readFormat=T.format,G.__readType=T.type,G.__formatReadable=oe.textureFormatReadable(T.format),G.__typeReadable=oe.textureTypeReadable(T.type)),G}this.readRenderTargetPixels=function(T,G,nt,J,j,Tt,It,At=0){if(!(T&&T.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Ht.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){wt.bindFramebuffer(V.FRAMEBUFFER,Lt);try{let Vt=T.textures[At],ee=Vt.format,pe=Vt.type;T.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+At);let zt=Pr(Vt);if(zt.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=T.width-J&&nt>=0&&nt<=T.height-j&&V.readPixels(G,nt,J,j,xt.convert(ee),xt.convert(pe),Tt)}finally{let Vt=it!==null?Ht.get(it).__webglFramebuffer:null;wt.bindFramebuffer(V.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(T,G,nt,J,j,Tt,It,At=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Ht.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(G>=0&&G<=T.width-J&&nt>=0&&nt<=T.height-j){wt.bindFramebuffer(V.FRAMEBUFFER,Lt);let Vt=T.textures[At],ee=Vt.format,pe=Vt.type;T.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+At);let zt=Pr(Vt);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let me=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,me),V.bufferData(V.PIXEL_PACK_BUFFER,Tt.byteLength,V.STREAM_READ),V.readPixels(G,nt,J,j,xt.convert(ee),xt.convert(pe),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let Ze=it!==null?Ht.get(it).__webglFramebuffer:null;wt.bindFramebuffer(V.FRAMEBUFFER,Ze);let Pe=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await Gg(V,Pe,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,me),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Tt),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(me),V.deleteSync(Pe),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,G=null,nt=0){let J=Math.pow(2,-nt),j=Math.floor(T.image.width*J),Tt=Math.floor(T.image.height*J),It=G!==null?G.x:0,At=G!==null?G.y:0;Yt.setTexture2D(T,0),V.copyTexSubImage2D(V.TEXTURE_2D,nt,0,0,It,At,j,Tt),wt.unbindTexture()},this.copyTextureToTexture=function(T,G,nt=null,J=null,j=0,Tt=0){let It,At,Lt,Vt,ee,pe,zt,me,Ze,Pe=T.isCompressedTexture?T.mipmaps[Tt]:T.image;if(nt!==null)It=nt.max.x-nt.min.x,At=nt.max.y-nt.min.y,Lt=nt.isBox3?nt.max.z-nt.min.z:1,Vt=nt.min.x,ee=nt.min.y,pe=nt.isBox3?nt.min.z:0;else{let de=Math.pow(2,-j);It=Math.floor(Pe.width*de),At=Math.floor(Pe.height*de),T.isDataArrayTexture?Lt=Pe.depth:T.isData3DTexture?Lt=Math.floor(Pe.depth*de):Lt=1,Vt=0,ee=0,pe=0}J!==null?(zt=J.x,me=J.y,Ze=J.z):(zt=0,me=0,Ze=0);let Ie=xt.convert(G.format),mn=xt.convert(G.type),Ut;G.isData3DTexture?(Yt.setTexture3D(G,0),Ut=V.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Yt.setTexture2DArray(G,0),Ut=V.TEXTURE_2D_ARRAY):(Yt.setTexture2D(G,0),Ut=V.TEXTURE_2D),wt.activeTexture(V.TEXTURE0),wt.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,G.flipY),wt.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),wt.pixelStorei(V.UNPACK_ALIGNMENT,G.unpackAlignment);let on=wt.getParameter(V.UNPACK_ROW_LENGTH),_e=wt.getParameter(V.UNPACK_IMAGE_HEIGHT),cs=wt.getParameter(V.UNPACK_SKIP_PIXELS),an=wt.getParameter(V.UNPACK_SKIP_ROWS),Ir=wt.getParameter(V.UNPACK_SKIP_IMAGES);wt.pixelStorei(V.UNPACK_ROW_LENGTH,Pe.width),wt.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Pe.height),wt.pixelStorei(V.UNPACK_SKIP_PIXELS,Vt),wt.pixelStorei(V.UNPACK_SKIP_ROWS,ee),wt.pixelStorei(V.UNPACK_SKIP_IMAGES,pe);let Wi=T.isDataArrayTexture||T.isData3DTexture,hs=G.isDataArrayTexture||G.isData3DTexture;if(T.isDepthTexture){let de=Ht.get(T),Ke=Ht.get(G),kn=Ht.get(de.__renderTarget),Le=Ht.get(Ke.__renderTarget);wt.bindFramebuffer(V.READ_FRAMEBUFFER,kn.__webglFramebuffer),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,Le.__webglFramebuffer);for(let ln=0;ln<Lt;ln++)Wi&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ht.get(T).__webglTexture,j,pe+ln),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ht.get(G).__webglTexture,Tt,Ze+ln)),V.blitFramebuffer(Vt,ee,Vt+It,ee+At,zt,me,zt+It,me+At,V.DEPTH_BUFFER_BIT,V.NEAREST);wt.bindFramebuffer(V.READ_FRAMEBUFFER,null),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(j!==0||T.isRenderTargetTexture||Ht.has(T)){let de=Ht.get(T),Ke=Ht.get(G);wt.bindFramebuffer(V.READ_FRAMEBUFFER,D),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,k);for(let kn=0;kn<Lt;kn++)Wi?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,de.__webglTexture,j,pe+kn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,de.__webglTexture,j),hs?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ke.__webglTexture,Tt,Ze+kn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Ke.__webglTexture,Tt),j!==0?V.blitFramebuffer(Vt,ee,Vt+It,ee+At,zt,me,zt+It,me+At,V.COLOR_BUFFER_BIT,V.NEAREST):hs?V.copyTexSubImage3D(Ut,Tt,zt,me,Ze+kn,Vt,ee,It,At):V.copyTexSubImage2D(Ut,Tt,zt,me,Vt,ee,It,At);wt.bindFramebuffer(V.READ_FRAMEBUFFER,null),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else hs?T.isDataTexture||T.isData3DTexture?V.texSubImage3D(Ut,Tt,zt,me,Ze,It,At,Lt,Ie,mn,Pe.data):G.isCompressedArrayTexture?V.compressedTexSubImage3D(Ut,Tt,zt,me,Ze,It,At,Lt,Ie,Pe.data):V.texSubImage3D(Ut,Tt,zt,me,Ze,It,At,Lt,Ie,mn,Pe):T.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Tt,zt,me,It,At,Ie,mn,Pe.data):T.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Tt,zt,me,Pe.width,Pe.height,Ie,Pe.data):V.texSubImage2D(V.TEXTURE_2D,Tt,zt,me,It,At,Ie,mn,Pe);wt.pixelStorei(V.UNPACK_ROW_LENGTH,on),wt.pixelStorei(V.UNPACK_IMAGE_HEIGHT,_e),wt.pixelStorei(V.UNPACK_SKIP_PIXELS,cs),wt.pixelStorei(V.UNPACK_SKIP_ROWS,an),wt.pixelStorei(V.UNPACK_SKIP_IMAGES,Ir),Tt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&V.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(T){Ht.get(T).__webglFramebuffer===void 0&&Yt.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Yt.setTextureCube(T,0):T.isData3DTexture?Yt.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Yt.setTexture2DArray(T,0):Yt.setTexture2D(T,0),wt.unbindTexture()},this.resetState=function(){q=0,O=0,it=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}};var E0=new mi,Th=new X,Io=class extends Ua{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new ze(t,3)),this.setAttribute("uv",new ze(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,i=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),i.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new Ys(e,6,1);return this.setAttribute("instanceStart",new Oi(i,3,0)),this.setAttribute("instanceEnd",new Oi(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new Ys(e,6,1);return this.setAttribute("instanceColorStart",new Oi(i,3,0)),this.setAttribute("instanceColorEnd",new Oi(i,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Aa(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new mi);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),E0.setFromBufferAttribute(e),this.boundingBox.union(E0))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fi),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Th.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Th)),Th.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Th));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Pt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Jt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Kn.line={uniforms:$a.merge([Pt.common,Pt.fog,Pt.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Qs=class extends bi{constructor(t){super({type:"LineMaterial",uniforms:$a.clone(Kn.line.uniforms),vertexShader:Kn.line.vertexShader,fragmentShader:Kn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var ef=new Re,T0=new X,A0=new X,Pn=new Re,In=new Re,ss=new Re,nf=new X,sf=new De,Ln=new Fa,C0=new X,Ah=new mi,Ch=new Fi,rs=new Re,os,Er;function R0(n,t,e){return rs.set(0,0,-t,1).applyMatrix4(n.projectionMatrix),rs.multiplyScalar(1/rs.w),rs.x=Er/e.width,rs.y=Er/e.height,rs.applyMatrix4(n.projectionMatrixInverse),rs.multiplyScalar(1/rs.w),Math.abs(Math.max(rs.x,rs.y))}function yw(n,t){let e=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Ln.start.fromBufferAttribute(s,a),Ln.end.fromBufferAttribute(r,a),Ln.applyMatrix4(e);let c=new X,u=new X;os.distanceSqToSegment(Ln.start,Ln.end,u,c),u.distanceTo(c)<Er*.5&&t.push({point:u,pointOnLine:c,distance:os.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function vw(n,t,e){let i=t.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),d=-t.near;os.at(1,ss),ss.w=1,ss.applyMatrix4(t.matrixWorldInverse),ss.applyMatrix4(i),ss.multiplyScalar(1/ss.w),ss.x*=r.x/2,ss.y*=r.y/2,ss.z=0,nf.copy(ss),sf.multiplyMatrices(t.matrixWorldInverse,o);for(let h=0,p=u;h<p;h++){if(Pn.fromBufferAttribute(l,h),In.fromBufferAttribute(c,h),Pn.w=1,In.w=1,Pn.applyMatrix4(sf),In.applyMatrix4(sf),Pn.z>d&&In.z>d)continue;if(Pn.z>d){let C=Pn.z-In.z,b=(Pn.z-d)/C;Pn.lerp(In,b)}else if(In.z>d){let C=In.z-Pn.z,b=(In.z-d)/C;In.lerp(Pn,b)}Pn.applyMatrix4(i),In.applyMatrix4(i),Pn.multiplyScalar(1/Pn.w),In.multiplyScalar(1/In.w),Pn.x*=r.x/2,Pn.y*=r.y/2,In.x*=r.x/2,In.y*=r.y/2,Ln.start.copy(Pn),Ln.start.z=0,Ln.end.copy(In),Ln.end.z=0;let x=Ln.closestPointToPointParameter(nf,!0);Ln.at(x,C0);let g=Ya.lerp(Pn.z,In.z,x),m=g>=-1&&g<=1,y=nf.distanceTo(C0)<Er*.5;if(m&&y){Ln.start.fromBufferAttribute(l,h),Ln.end.fromBufferAttribute(c,h),Ln.start.applyMatrix4(o),Ln.end.applyMatrix4(o);let C=new X,b=new X;os.distanceSqToSegment(Ln.start,Ln.end,b,C),e.push({point:b,pointOnLine:C,distance:os.origin.distanceTo(b),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var Rh=class extends Fn{constructor(t=new Io,e=new Qs({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,i=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)T0.fromBufferAttribute(e,o),A0.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+T0.distanceTo(A0);let r=new Ys(s,2,1);return t.setAttribute("instanceDistanceStart",new Oi(r,1,0)),t.setAttribute("instanceDistanceEnd",new Oi(r,1,1)),this}raycast(t,e){let i=this.material.worldUnits,s=t.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;os=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Er=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Ch.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=Er*.5;else{let d=Math.max(s.near,Ch.distanceToPoint(os.origin));c=R0(s,d,l.resolution)}if(Ch.radius+=c,os.intersectsSphere(Ch)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Ah.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=Er*.5;else{let d=Math.max(s.near,Ah.distanceToPoint(os.origin));u=R0(s,d,l.resolution)}Ah.expandByScalar(u),os.intersectsBox(Ah)!==!1&&(i?yw(this,e):vw(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(ef),this.material.uniforms.resolution.value.set(ef.z,ef.w))}};var Tr=class extends Io{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setPositions(i),this}setColors(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setColors(i),this}setFromPoints(t){let e=t.length-1,i=new Float32Array(6*e);for(let s=0;s<e;s++)i[6*s]=t[s].x,i[6*s+1]=t[s].y,i[6*s+2]=t[s].z||0,i[6*s+3]=t[s+1].x,i[6*s+4]=t[s+1].y,i[6*s+5]=t[s+1].z||0;return super.setPositions(i),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Ph=class extends Rh{constructor(t=new Tr,e=new Qs({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var Sw=new X(0,1,0),Mw=new So(1,1,1,40),bw=new Ta(1,32,20),ww=new Hs(1,1,1),Ew=new Ea(1,1,24);function Lo(n){return new Mo({color:n,roughness:.55,metalness:.08})}function Ih(n,t,e=!0){let i=new Fn(n,t);return i.castShadow=e,i.receiveShadow=e,i}var Ts=(n,t)=>Ih(Mw,n,t),Qa=n=>Ih(bw,n),P0=n=>Ih(ww,n),I0=n=>Ih(Ew,n,!1);function tr(n,t,e,i){let s=hn(e,t),r=Zi(s);n.visible=r>1e-9,n.visible&&(n.position.set(...ne(t,Gt(s,.5))),n.quaternion.setFromUnitVectors(Sw,new X(...Gt(s,1/r))),n.scale.set(i,r,i))}function tl(n,t,e,i,s){let r=Gt(e,i/2);tr(n,hn(t,r),ne(t,r),s)}function L0(n,t,e,[i,s,r]){n.position.set(...t);let o=[...e.x,0,...e.y,0,...e.z,0,0,0,0,1];n.quaternion.setFromRotationMatrix(new De().fromArray(o)),n.scale.set(i,s,r)}function Do(n,t,e=!1){let i=new Ph(new Tr,new Qs({color:n,linewidth:t}));return i.frustumCulled=!1,e&&(i.material.depthTest=!1,i.material.transparent=!0,i.renderOrder=2),i}function Lh(n,t){n.visible=t.length>1,n.visible&&(n.geometry.dispose(),n.geometry=new Tr,n.geometry.setPositions(t.flat()))}function D0(){let n=document.createElement("canvas");[n.width,n.height]=[8,4];let t=n.getContext("2d");for(let i=0;i<4;i++)for(let s=0;s<2;s++)t.fillStyle=(i+s)%2===0?"#111418":"#ffffff",t.fillRect(2*i,2*s,2,2);let e=new Ma(n);return e.colorSpace=Xn,e.magFilter=fn,new Mo({map:e,roughness:.6})}var Tw=["#e03131","#2f9e44","#1c7ed6"];function Aw(){let n=new Yn,t=Tw.map(i=>{let s=Lo(i),[r,o]=[Ts(s,!1),I0(s)];return n.add(r,o),{rod:r,head:o}});return{group:n,put:(i,s)=>{[i.x,i.y,i.z].forEach((r,o)=>{let[a,l]=[.78,1].map(c=>ne(i.o,Gt(r,c*s)));tr(t[o].rod,i.o,a,.032*s),tr(t[o].head,a,l,.085*s)})}}}function er(n){let t=n.rows.map((e,i)=>({row:e,index:i}));return n.isMounted?t.filter(({row:e})=>e.mount!==null):t}function N0(n,t,e){let i=er(t),s=.034*e/Math.sqrt(Math.max(1,i.length/6)),r=M=>s*(1-.45*M/Math.max(i.length,4)),o=Lo("#c9d1db"),a=Lo("#5c6673"),l=new Yn;n.scene.add(l);let c=(M,f=l)=>(f.add(M),M),u={disc:c(Ts(a)),post:c(Ts(a))},d=i.map(({row:M})=>{let f=Lo("#888888");return{color:f,body:M.isPlace?null:c(M.type==="prismatic"?P0(f):Ts(f)),caps:M.isPlace||M.type==="prismatic"?[]:[0,1].map(()=>c(Ts(a))),rods:[0,1].map(()=>c(Ts(o))),corners:[0,1].map(()=>c(Qa(o)))}}),h=t.tips.map(()=>({rod:c(Ts(o)),ball:c(Qa(a)),stub:c(Ts(o))})),p=c(new Yn),_=[...i,"base","world",...t.tips].map(()=>{let M=Aw();return p.add(M.group),M}),x=c(new Yn),g=i.map(({row:M})=>{let f=Do("#888888",1.6);return f.material.dashed=!0,x.add(f),f.visible=!M.isPlace,f}),m=c(new Yn),y=D0(),C=[...t.rows,...t.tips].map(()=>c(Qa(y),m)),b=c(Qa(Lo("#f08c00")),m);function A(M,f,S){let{row:I,index:R}=i[f],{middle:P,frame:U,link:B,origin:D,axis:k,before:q}=M.rows[R],{body:O,caps:it,rods:Y,corners:K}=d[f],tt=r(f),ht=t.isMounted?B.o:P.o,et=t.isMounted?B.o:U.o;if(tr(Y[0],S,ht,.52*tt),tr(Y[1],ht,et,.52*tt),[ht,et].forEach(($,ft)=>{K[ft].position.set(...$),K[ft].scale.setScalar(.52*tt)}),!O)return et;if(I.type==="prismatic"){let $=t.convention==="standard"?q:P;L0(O,t.isMounted?S:D,{...$,z:k},[1.7*tt,1.7*tt,3.4*tt])}else{let $=t.isMounted?B.o:t.convention==="standard"?D:U.o;tl(O,$,k,2.5*tt,tt),it.forEach((ft,gt)=>{tl(ft,ne($,Gt(k,(gt===0?1.3:-1.3)*tt)),k,.12*tt,.5*tt)})}return et}return{paint(M){d.forEach(({color:f},S)=>{f.color.set(M(i[S].row)),g[S].material.color.set(M(i[S].row))}),n.ask()},show({frames:M,axes:f,masses:S}){p.visible=M,x.visible=f,m.visible=S,o.transparent=S,o.opacity=S?.45:1,n.ask()},put(M,f){let S=r(0),I=M.base.o;tl(u.disc,hn(I,Gt(M.base.z,1.75*S)),M.base.z,.9*S,1.9*S),tl(u.post,hn(I,Gt(M.base.z,1.1*S)),M.base.z,.6*S,1.25*S);let R=new Map([[null,I]]);i.forEach(({row:O,index:it},Y)=>R.set(it,A(M,Y,R.get(O.on)??I)));let P=r(i.length);h.forEach((O,it)=>{let{on:Y}=f.tips[it],[K,tt]=[R.get(Y)??I,M.tips[it].o];tr(O.rod,K,tt,.45*P),O.ball.position.set(...tt),O.ball.scale.setScalar(.62*P);let ht=Y===null?M.base:M.rows[Y].link,et=Y!==null&&f.convention==="modified"&&Ds(K,tt)<.01*e;tr(O.stub,ht.o,et?Xo(ht,f.rows[Y].com):ht.o,.45*P)});let U=.13*e;i.forEach(({index:O},it)=>_[it].put(M.rows[O].link,U)),_[i.length].put(M.base,1.15*U),_[i.length+1].put({x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]},1.5*U),M.tips.forEach((O,it)=>_[i.length+2+it].put(O,U)),i.forEach(({row:O,index:it},Y)=>{if(O.isPlace)return;let{origin:K,axis:tt,link:ht}=M.rows[it],et=t.isMounted?ht.o:K;Lh(g[Y],[-.16,.16].map($=>ne(et,Gt(tt,$*e))))});let[B,D]=[0,[0,0,0]],k=f.rows.map((O,it)=>({...O,frame:M.rows[it].link}));f.tips.forEach(({on:O,body:it},Y)=>k.push({...O===null?null:it,frame:M.tips[Y]})),C.forEach((O,it)=>{let Y=k[it];if(O.visible=Y.mass>0,!O.visible)return;let K=Xo(Y.frame,Y.com);O.position.set(...K),B+=Y.mass,D=ne(D,Gt(K,Y.mass))});let q=Math.max(...k.map(O=>O.mass??0));C.forEach((O,it)=>{O.visible&&O.scale.setScalar(.034*e*Math.cbrt(k[it].mass/q))}),b.visible=B>0,B>0&&b.position.set(...Gt(D,1/B)),b.scale.setScalar(.02*e),n.ask()}}}function U0(n,t,e){let i=[t.base.o,...t.tips.map(r=>r.o)];for(let{index:r}of er(n)){let{middle:o,link:a}=t.rows[r];i.push(a.o),n.isMounted||i.push(o.o)}for(let{on:r}of n.tips)r!==null&&i.push(Xo(t.rows[r].link,n.rows[r].com));let s=.05*e;return i.flatMap(r=>[r,...[0,1,2].flatMap(o=>[-s,s].map(a=>r.map((l,c)=>c===o?l+a:l)))])}var nr={theta:"#e64980",d:"#228be6",a:"#37b24d",alpha:"#f76707"},F0={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},B0="#868e96";function O0(n,t,e,i,s){let r=Math.max(2,Math.ceil(Math.abs(i)/.06)),o=Gt(Qn(hn(e,Gt(t,Ai(t,e)))),s);return Array.from({length:r+1},(a,l)=>ne(n,Wo(o,t,i*l/r)))}function Cw(n,t){let e=n[n.length-1],i=Qn(hn(e,n[n.length-2])),s=Qn(Ji(i,Math.abs(i[2])<.9?[0,0,1]:[1,0,0]));return[1,-1].map(r=>ne(e,ne(Gt(i,-t),Gt(s,.4*r*t))))}function Rw(n,t,e,i,s){let r=n.rows[e],{before:o,middle:a,frame:l,theta:c,d:u}=t.rows[e],d=n.convention==="standard",h=.115*s,p=e+1,_={paths:[],texts:[]},x=(R,P,U,B)=>{_.paths.push({color:nr[R],path:P,width:3.2});let[D,k]=Cw(P,.03*s),q=P[P.length-1];_.paths.push({color:nr[R],path:[D,q,k],width:3.2});let O=!d&&(R==="a"||R==="alpha")?p-1:p;_.texts.push({at:U,name:R,sign:F0[R],index:O,text:B})},g=(R,P)=>_.paths.push({color:B0,path:[R,P],width:1.4}),m=R=>R[Math.floor(R.length/2)],[y,C]=d?[o,a]:[a,l],[b,A]=d?[a,l]:[o,a],M=d?y.o:C.o,f=d?A.o:b.o,S=R=>Math.abs(R)<1e-9,I=y.z;for(let R of[y.x,C.x])g(M,ne(M,Gt(R,1.25*h)));if(S(c))_.texts.push({at:ne(M,Gt(C.x,1.3*h)),name:"theta",sign:F0.theta,index:p,text:i.angle(0)});else{let R=O0(M,I,y.x,c,h),P=Qn(hn(m(R),M));x("theta",R,ne(M,Gt(P,1.2*h)),i.angle(c))}if(Math.abs(u)>1e-9&&x("d",[y.o,C.o],Gt(ne(y.o,C.o),.5),i.length(u)),Math.abs(r.a)>1e-9&&x("a",[b.o,A.o],Gt(ne(b.o,A.o),.5),i.length(r.a)),!S(r.alpha)){for(let U of[b.z,A.z])g(f,ne(f,Gt(U,1.25*h)));let R=O0(f,b.x,b.z,r.alpha,h),P=Qn(hn(m(R),f));x("alpha",R,ne(f,Gt(P,1.2*h)),i.angle(r.alpha))}return _}function Pw(n,t,e,i,s,r){let{link:o,axis:a}=t.rows[e],l={paths:[],texts:[]},c=[i.o,o.o];if(Ds(...c)>1e-9){l.paths.push({color:nr.a,path:c,width:3.2});let d=hn(o.o,i.o),h=[i.x,i.y,i.z].map(p=>s.number(Ai(p,d)));l.texts.push({at:Gt(ne(...c),.5),name:"a",sign:"xyz",index:null,text:`${h.join(", ")} m`})}let u=ne(o.o,Gt(a,.2*r));return l.paths.push({color:nr.theta,path:[o.o,u],width:3.2}),l.texts.push({at:u,name:"theta",sign:"axis",index:null,text:""}),l}function k0(n,t,e){let i=new Yn;n.scene.add(i);let s=[],r=er(t);return{put(o,a,l,c){let u=l.map(h=>{if(!t.isMounted)return Rw(a,o,h,c,e);let p=r.findIndex(x=>x.index===h),_=p>0?o.rows[r[p-1].index].link:o.base;return Pw(a,o,h,_,c,e)}),d=u.flatMap(({paths:h})=>h);for(;s.length<d.length;){let h=Do(B0,1,!0);i.add(h),s.push(h)}return s.forEach((h,p)=>{h.visible=p<d.length,h.visible&&(Lh(h,d[p].path),h.material.color.set(d[p].color),h.material.linewidth=d[p].width)}),n.ask(),u.flatMap(({texts:h})=>h)}}}var el=2;function z0(n,t){let e=[],i=[];function s(){let r=[],{clientWidth:o,clientHeight:a}=t;e.forEach(({at:l},c)=>{let u=i[c],d=n.onCanvas(l);if(u.hidden=d===null,!d)return;let[h,p]=[u.offsetWidth,u.offsetHeight],_=Math.min(Math.max(d[0]-h/2,2),o-h-2),x=Math.min(Math.max(d[1]-p/2,2),a-p-2);for(let g=0;g<12;g++){let m=r.find(y=>!(_>y.x+y.wide+el||y.x>_+h+el)&&x<y.y+y.high+el&&y.y<x+p+el);if(!m)break;x=m.y+m.high+el+.5}r.push({x:_,y:x,wide:h,high:p}),u.style.transform=`translate(${_}px, ${x}px)`})}return n.onDraw(s),{put(r){for(e=r;i.length<r.length;)i.push(t.appendChild(H("span")));i.forEach((o,a)=>{if(o.hidden=a>=r.length,o.hidden)return;let{content:l,kind:c,color:u}=r[a];o.className=`label ${c}`,o.style.setProperty("--color",u),o.replaceChildren(...[l].flat())}),n.ask()}}}var V0={type:"change"},of={type:"start"},H0={type:"end"},Dh=new xr,G0=new fi,Iw=Math.cos(70*Ya.DEG2RAD),vn=new X,ni=2*Math.PI,Te={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},rf=1e-6,Nh=class extends Ba{constructor(t,e=null){super(t,e),this.state=Te.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:$s.ROTATE,MIDDLE:$s.DOLLY,RIGHT:$s.PAN},this.touches={ONE:Zs.ROTATE,TWO:Zs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new Zn,this._lastTargetPosition=new X,this._quat=new Zn().setFromUnitVectors(t.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new wo,this._sphericalDelta=new wo,this._scale=1,this._panOffset=new X,this._rotateStart=new Jt,this._rotateEnd=new Jt,this._rotateDelta=new Jt,this._panStart=new Jt,this._panEnd=new Jt,this._panDelta=new Jt,this._dollyStart=new Jt,this._dollyEnd=new Jt,this._dollyDelta=new Jt,this._dollyDirection=new X,this._mouse=new Jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Dw.bind(this),this._onPointerDown=Lw.bind(this),this._onPointerUp=Nw.bind(this),this._onContextMenu=Vw.bind(this),this._onMouseWheel=Ow.bind(this),this._onKeyDown=Bw.bind(this),this._onTouchStart=kw.bind(this),this._onTouchMove=zw.bind(this),this._onMouseDown=Uw.bind(this),this._onMouseMove=Fw.bind(this),this._interceptControlDown=Gw.bind(this),this._interceptControlUp=Hw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Te.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(V0),this.update(),this.state=Te.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;vn.copy(e).sub(this.target),vn.applyQuaternion(this._quat),this._spherical.setFromVector3(vn),this.autoRotate&&this.state===Te.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ni:i>Math.PI&&(i-=ni),s<-Math.PI?s+=ni:s>Math.PI&&(s-=ni),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(vn.setFromSpherical(this._spherical),vn.applyQuaternion(this._quatInverse),e.copy(this.target).add(vn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=vn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=vn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Dh.origin.copy(this.object.position),Dh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Dh.direction))<Iw?this.object.lookAt(this.target):(G0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Dh.intersectPlane(G0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>rf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>rf||this._lastTargetPosition.distanceToSquared(this.target)>rf?(this.dispatchEvent(V0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ni/60*this.autoRotateSpeed*t:ni/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){vn.setFromMatrixColumn(e,0),vn.multiplyScalar(-t),this._panOffset.add(vn)}_panUp(t,e){this.screenSpacePanning===!0?vn.setFromMatrixColumn(e,1):(vn.setFromMatrixColumn(e,0),vn.crossVectors(this.object.up,vn)),vn.multiplyScalar(t),this._panOffset.add(vn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;vn.copy(s).sub(this.target);let r=vn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/e.clientHeight),this._rotateUp(ni*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/e.clientHeight),this._rotateUp(ni*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function Lw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Dw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function Nw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(H0),this.state=Te.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Uw(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case $s.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Te.DOLLY;break;case $s.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Te.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Te.ROTATE}break;case $s.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Te.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Te.PAN}break;default:this.state=Te.NONE}this.state!==Te.NONE&&this.dispatchEvent(of)}function Fw(n){switch(this.state){case Te.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Te.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Te.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Ow(n){this.enabled===!1||this.enableZoom===!1||this.state!==Te.NONE||(n.preventDefault(),this.dispatchEvent(of),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(H0))}function Bw(n){this.enabled!==!1&&this._handleKeyDown(n)}function kw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Zs.ROTATE:if(this.enableRotate===!1){this.state=Te.NONE;break}this._handleTouchStartRotate(n),this.state=Te.TOUCH_ROTATE;break;case Zs.PAN:if(this.enablePan===!1){this.state=Te.NONE;break}this._handleTouchStartPan(n),this.state=Te.TOUCH_PAN;break;default:this.state=Te.NONE}break;case 2:switch(this.touches.TWO){case Zs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Te.TOUCH_DOLLY_PAN;break;case Zs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Te.TOUCH_DOLLY_ROTATE;break;default:this.state=Te.NONE}break;default:this.state=Te.NONE}this.state!==Te.NONE&&this.dispatchEvent(of)}function zw(n){switch(this._trackPointer(n),this.state){case Te.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Te.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Te.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Te.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Te.NONE}}function Vw(n){this.enabled!==!1&&n.preventDefault()}function Gw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Hw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function af(n){let t=Math.abs(n[0])<.9?[1,0,0]:[0,1,0],e=Qn(hn(t,Gt(n,Ai(t,n))));return[e,Ji(n,e)]}function W0(n,t,e){let i;try{i=new bh({canvas:n,antialias:!0,alpha:!0})}catch{return null}i.shadowMap.enabled=!0;let s=new _a,r=new qn(32,1,e/100,e*60);r.up.set(...t);let o=new Nh(r,n);o.enableDamping=!1,o.minDistance=e/10,o.maxDistance=e*20;let a=new Ia(16777215,9279912,1.6);a.position.set(...t);let[l,c]=af(t),u=new Na(16777215,2.2),d=ne(ne(Gt(t,2.2),Gt(l,.9)),Gt(c,-1.1));u.castShadow=!0,u.shadow.mapSize.set(1024,1024),u.shadow.radius=5,u.shadow.bias=-5e-4,u.shadow.normalBias=e/200,Object.assign(u.shadow.camera,{left:-1.6*e,right:1.6*e,top:1.6*e,bottom:-1.6*e,near:.1*e,far:8*e}),s.add(a,u,u.target);let h=new Zn().setFromUnitVectors(new X(0,0,1),new X(...t)),p=new Fn(new yr(12*e,12*e),new Ca({opacity:.16}));p.quaternion.copy(h),p.receiveShadow=!0,s.add(p);let _=null,x=!1,g=[],m=()=>{x=!1,i.render(s,r),g.forEach(b=>b())},y=()=>{x||requestAnimationFrame(m),x=!0};o.addEventListener("change",y);let C=()=>{let{clientWidth:b,clientHeight:A}=n;b===0||A===0||(i.setPixelRatio(Math.min(devicePixelRatio,2)),i.setSize(b,A,!1),r.aspect=b/A,r.updateProjectionMatrix(),y())};return new ResizeObserver(C).observe(n),{scene:s,camera:r,canvas:n,ask:y,onDraw:b=>g.push(b),ground(b,A,M){let f=ne(b,Gt(t,A-Ai(b,t)));p.position.set(...f),u.target.position.set(...b),u.position.set(...ne(b,Gt(Qn(d),4*e))),_&&s.remove(_);let S=10**Math.floor(Math.log10(e/2)),I=[1,2,5,10].map(P=>P*S).find(P=>P>=e/8),R=2*Math.ceil(2*e/I);return _=new Oa(R*I,R,new le(M[0]),new le(M[1])),_.quaternion.setFromUnitVectors(new X(0,1,0),new X(...t)),_.position.set(...ne(f,Gt(t,-e/500))),s.add(_),y(),I},look(b,A){C();let f=[0,1,2].map(U=>A.map(B=>B[U])).map(U=>(Math.min(...U)+Math.max(...U))/2),S=Math.max(...A.map(U=>Zi(hn(U,f))),e/8),I=r.fov*Math.PI/360,R=Math.min(I,Math.atan(Math.tan(I)*r.aspect)),P=1.12*S/Math.sin(R);r.position.set(...ne(f,Gt(Qn(b),P))),o.target.set(...f),o.update(),y()},turn(b,A){let M=o.target.toArray(),f=hn(r.position.toArray(),M),S=Qn(Ji(t,f)),I=Wo(Wo(f,t,b),S,-A);Zi(Ji(Qn(I),t))<.05||(r.position.set(...ne(M,I)),o.update(),y())},zoom(b){let A=o.target.toArray(),M=hn(r.position.toArray(),A);r.position.set(...ne(A,Gt(M,b))),o.update(),y()},onCanvas(b){let A=new X(...b).project(r);if(A.z>1)return null;let{clientWidth:M,clientHeight:f}=n;return[(A.x+1)/2*M,(1-A.y)/2*f]}}}var Ww=[.1,.25,.5,1,2],X0={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z"};function Xw(n){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidden","true");let e=document.createElementNS("http://www.w3.org/2000/svg","path");return e.setAttribute("d",n),t.append(e),t}function q0(n){let{state:t}=n,e=H("button",{type:"button",class:"play","data-key":"play"}),i=H("input",{type:"range",min:0,step:"any","data-key":"time","aria-label":"Time"}),s=H("output",{class:"time","data-key":"seconds"}),r=H("select",{"aria-label":"Speed","data-key":"speed"},Ww.map(h=>H("option",{value:h,selected:h===1},`${h}\xD7`))),o=H("input",{type:"checkbox","data-key":"repeat"}),a=null;function l(h){if(!t.isPlaying){a=null;return}if(a!==null){let{duration:p}=n.trajectory,_=t.t+(h-a)/1e3*t.speed;_>=p&&o.checked&&p>0&&(_%=p),_>=p&&n.play(!1),n.setTime(_)}a=h,requestAnimationFrame(l)}function c(){e.replaceChildren(Xw(t.isPlaying?X0.pause:X0.play)),e.setAttribute("aria-label",t.isPlaying?"Pause":"Play"),t.isPlaying&&a===null&&requestAnimationFrame(l)}function u(){let{duration:h}=n.trajectory??{duration:0};i.max=h,i.value=t.t;let p=`${t.t.toFixed(2)} / ${h.toFixed(2)} s`;i.setAttribute("aria-valuetext",p),s.textContent=p,d.hidden=n.trajectory===null}e.addEventListener("click",()=>n.play(!t.isPlaying)),i.addEventListener("input",()=>{n.play(!1),n.setTime(Number(i.value))}),r.addEventListener("change",()=>t.speed=Number(r.value));let d=H("div",{class:"transport",role:"group","aria-label":"Time"},e,i,s,r,H("label",{class:"check"},o,"repeat"));return n.on("play",c),n.on("time trajectory",u),c(),u(),d}function qw(n){return Zi(n.gravity)>1e-9?Qn(Gt(n.gravity,-1)):[0,0,1]}function Yw(n,t){let{rows:e}=zr(n,new Array(n.dof).fill(0)),i=n.rows.flatMap((o,a)=>o.type==="revolute"&&o.joint!==null?[e[a].axis]:[]);if(i.length===0)return null;let[s]=i;return i.every(o=>Zi(Ji(s,o))<1e-6)&&Math.abs(Ai(s,t))<1e-6?s:null}function Y0(n){let{table:t,state:e,size:i}=n,s=H("canvas",{tabIndex:0,role:"img"}),r=H("div",{class:"labels","aria-hidden":"true"}),o=H("output",{class:"readout"}),a=H("span",{class:"scale"}),l=H("div",{class:"views",role:"group","aria-label":"View"}),c=H("div",{class:"shown",role:"group","aria-label":"What is shown"}),u=H("div",{class:"view"},s,r,l,o,a),d=H("section",{class:"panel stage","aria-label":"The arm"},u,c,q0(n));s.setAttribute("aria-label",`${t.name} in 3D; drag to turn, arrow keys too, plus and minus to zoom`);function h(){let g=qw(t),m=W0(s,g,i);if(!m){u.classList.add("missing"),u.append(H("p",{},"This browser draws no WebGL: the arm is not shown. All numbers are."));return}let y=N0(m,t,i),C=k0(m,t,i),b=z0(m,r),A=er(t),M=Do("#f08c00",2.4);M.visible=!1,m.scene.add(M);let f=Yw(t,g),[S,I]=af(g),R=f??Gt(I,-1),P=Ji(g,R),B={"3D":f?ne(ne(R,Gt(P,.22)),Gt(g,.16)):ne(ne(Gt(S,.75),Gt(I,-.9)),Gt(g,.55)),front:ne(R,Gt(g,1e-4)),side:ne(P,Gt(g,1e-4)),top:ne(g,Gt(R,.001))},D="3D";function k(et){D=et;let $=n.trajectory?n.trajectory.q:[e.q],ft=Math.max(1,Math.floor($.length/12)),gt=$.filter((Ft,qt)=>qt%ft===0||qt===$.length-1),vt=n.frames().base.o,_t=[e.q,...gt].flatMap(Ft=>U0(n.table,zr(n.table,Ft),i)).filter(Ft=>Ds(Ft,vt)<1.6*i);q=Math.min(..._t.map(Ft=>Ai(Ft,g)),Ai(vt,g)-.09*i),O(),m.look(B[et],_t.length>0?_t:[vt])}let q=0;function O(){let{base:et}=n.frames(),$=m.ground(et.o,q,[fr("--grid-strong"),fr("--grid")]);a.textContent=`grid ${$>=1?$:Number($.toPrecision(3))} m`}for(let et of Object.keys(B))l.append(H("button",{type:"button",class:"chip","data-key":`view-${et}`,onclick:()=>k(et)},et));s.addEventListener("keydown",({key:et})=>{let $={ArrowLeft:[-.1,0],ArrowRight:[.1,0],ArrowUp:[0,.1],ArrowDown:[0,-.1]};$[et]&&m.turn(...$[et]),(et==="+"||et==="-")&&m.zoom(et==="+"?.9:1/.9)});function it(){let{parameters:et}=e.show;if(et==="none")return[];let $=A.filter(({row:ft})=>!ft.isPlace).map(({index:ft})=>ft);return et==="all"?$:$.filter(ft=>ft===e.selected)}function Y(){let et=n.frames();y.put(et,n.table);let $=C.put(et,n.table,it(),n.units),ft=e.show.frames?[{at:et.base.o,content:"0",kind:"frame",color:"var(--ink)"},...A.map(({row:qt,index:Ot},ce)=>({at:et.rows[Ot].link.o,content:qt.isPlace?"tip":String(ce+1),kind:"frame",color:"var(--ink)"})),...(t.tips.length>1?t.tips:[]).map(({name:qt},Ot)=>({at:et.tips[Ot].o,content:qt,kind:"frame",color:"var(--ink)"}))]:[],gt=$.map(({at:qt,name:Ot,sign:ce,index:he,text:Kt})=>({at:qt,content:[...ai(ce,he),Kt?` = ${Kt}`:""],kind:"parameter",color:nr[Ot]}));b.put([...ft,...gt]);let[vt,_t,Ft]=et.tips[e.tip].o.map(qt=>(Math.abs(qt)<5e-7?0:qt).toFixed(4));o.textContent=`${n.tip().name}  x ${vt}  y ${_t}  z ${Ft} m`,tt()}function K(){let{trajectory:et}=n,$=et?.tip??[];M.visible=$.length>1,M.visible&&(M.geometry.dispose(),M.geometry=new M.geometry.constructor,M.geometry.setPositions($.flat()),tt())}function tt(){let{trajectory:et}=n;if(!et||et.t.length<2){M.visible=!1;return}let $=Math.floor(e.t/et.duration*(et.t.length-1)+1e-9);M.visible=e.show.trace&&$>0,M.geometry.instanceCount=$,m.ask()}function ht(){let et=$=>$.joint??$.follows?.joint;y.paint($=>fr(et($)===void 0?"--muted":`--joint-${et($)%8}`)),M.material.color.set(fr("--trace")),O()}n.on("time fields units selection tip",Y),n.on("trajectory",K),n.on("show",()=>{y.show(e.show),Y()}),n.on("theme",ht),n.on("mode",()=>k(D)),y.show(e.show),k("3D"),ht(),Y(),K(),requestAnimationFrame(()=>k("3D"))}let p=H("select",{"data-key":"parameters"},Object.entries({selected:"selected row",all:"all rows",none:"none"}).map(([g,m])=>H("option",{value:g},m)));p.addEventListener("change",()=>n.setShown({parameters:p.value}));let _=t.isMounted?"placement":"D-H parameters";if(c.append(H("label",{class:"choice"},H("span",{},_),p)),t.tips.length>1){let g=H("select",{"data-key":"tip"},t.tips.map(({name:m},y)=>H("option",{value:y},m)));g.addEventListener("change",()=>n.setTip(Number(g.value))),c.append(H("label",{class:"choice"},H("span",{},"frame"),g))}let x={frames:"frames",axes:"axes",masses:"masses",trace:"trace"};for(let[g,m]of Object.entries(x)){let y=H("input",{type:"checkbox",checked:e.show[g],"data-key":`show-${g}`});y.addEventListener("change",()=>n.setShown({[g]:y.checked})),c.append(H("label",{class:"check"},y,m))}return{section:d,start:h}}var $w={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},Zw={standard:["theta","d","a","alpha"],modified:["alpha","a","d","theta"]},No=(n,t=4)=>n.map(e=>Se(e,t)).join(", ");function $0(n){let{table:t,state:e}=n,i=er(t),s=t.isMounted?["xyz","rpy","axis"]:Zw[t.convention],r=t.rows.some(f=>f.limits),o=t.rows.some(f=>f.gearRatio!==0&&f.motorInertia!==0),a=t.rows.some(f=>f.viscous||f.coulomb.some(Boolean)||f.stribeck||f.spring),l=H("input",{type:"checkbox","data-key":"bodies"}),c=H("thead"),u=H("tbody"),d=H("caption");function h(){let{angleUnit:f}=n.units,S=R=>t.convention==="modified"&&(R==="a"||R==="alpha"),I=s.map(R=>{if(t.isMounted){let D={xyz:"m",rpy:f,axis:""}[R];return H("th",{scope:"col"},R," ",H("span",{class:"unit"},D))}let P=H("span",{class:"swatch"});P.style.background=nr[R];let U=R==="a"||R==="d"?"m":f,B=ai($w[R],S(R)?"i\u22121":"i");return H("th",{scope:"col"},P,B," ",H("span",{class:"unit"},U))});r&&I.push(H("th",{scope:"col"},"limits")),I.push(H("th",{scope:"col"},"mass ",H("span",{class:"unit"},"kg"))),l.checked&&(I.push(H("th",{scope:"col"},"centre of mass ",H("span",{class:"unit"},"m"))),I.push(H("th",{scope:"col"},"inertia xx, yy, zz, xy, yz, xz ",H("span",{class:"unit"},"kg m\xB2"))),o&&I.push(H("th",{scope:"col"},"motor")),a&&I.push(H("th",{scope:"col"},"friction, spring"))),c.replaceChildren(H("tr",{},H("th",{scope:"col"},"joint"),I))}function p(f){if(f.joint!==null)return ai("q",f.joint+1);if(!f.follows)return null;let{joint:S,factor:I,offset:R}=f.follows,P=I===1?"":I===-1?"-":`${Se(I)} `,U=R===0?"":` ${R<0?"-":"+"} ${Se(Math.abs(R))}`;return[P,...ai("q",S+1),U]}function _(f,S){let{cell:I}=n.units;if(t.isMounted){let{places:q,axis:O}=f.mount,it=Nf(q),[Y,K]=O,tt=[Math.sin(K)*Math.cos(Y),Math.sin(K)*Math.sin(Y),Math.cos(K)],ht={xyz:No(it.xyz),rpy:it.rpy.map(I).join(", "),axis:No(tt.map(et=>Math.abs(et)<1e-12?0:et))};return H("td",{},S==="axis"&&f.isPlace?"":ht[S])}let R=S==="theta"||S==="alpha",P=R?I(f[S]):Se(f[S],6),U=f.text[S],B=S===(f.type==="prismatic"?"d":"theta"),D=B?p(f):null,k=U?[H("i",{},U),H("span",{class:"unit"},` = ${P}`)]:[P];if(D)return H("td",{class:"variable"},D,f[S]===0&&!U?null:[" + ",k]);if(B&&f.locked!==null&&!f.isPlace){let q=f[S]+f.locked;return H("td",{},R?I(q):Se(q,6)," ",H("span",{class:"kind"},"locked"))}return H("td",{},k)}function x(f){let{viscous:S,coulomb:I,stribeck:R,spring:P}=f,U=I[0]===I[1];return[S?`viscous ${Se(S)}`:null,I.some(Boolean)?`Coulomb ${U?Se(I[0]):`+${Se(I[0])} / -${Se(I[1])}`}`:null,R?`static ${Se(R.friction)} below ${Se(R.velocity)}`:null,P?`spring ${Se(P.stiffness)} at ${Se(P.rest)}`:null].filter(Boolean).join(", ")}let g=({xyz:f,rpy:S})=>`xyz ${No(f)} m, rpy ${S.map(n.units.cell).join(", ")} ${n.units.angleUnit}`,m=f=>f===null?"the base":t.rows[f].name;function y(f,S){return f.follows?t.isMounted?["follows ",p(S)]:"follows":f.locked===null?f.type:t.isMounted?`locked at ${Se(S.locked*n.units.factor(f.type))} ${n.units.position(f.type)}`:"locked"}function C({row:f,index:S}){let I=n.table.rows[S],{factor:R,position:P}=n.units,U=f.joint??f.follows?.joint,B=H("th",{scope:"row"});if(f.isPlace)B.append("tip");else{let k=H("button",{type:"button",class:"name",onclick:()=>n.select(S)});k.append(H("span",{class:"dot"}),f.name||"fixed"," "),k.append(H("span",{class:"kind"},y(f,I))),(f.on??-1)!==S-1&&k.append(H("span",{class:"kind"},` on ${m(f.on)}`));let q=t.isMounted?[]:I.step.map(O=>`, at ${g(O)}`);k.append(H("span",{class:"kind"},...q)),B.append(k)}B.style.setProperty("--color",U===void 0?"var(--muted)":`var(--joint-${U%8})`);let D=s.map(k=>_(I,k));if(r){let k=R(f.type),q=I.limits?.map(O=>Se(O*k));D.push(H("td",{},q?`${q[0]} \u2026 ${q[1]} ${P(f.type)}`:""))}if(D.push(H("td",{},I.text.mass?[H("i",{},I.text.mass),` = ${Se(I.mass)}`]:Se(I.mass))),l.checked){D.push(H("td",{},No(I.com)),H("td",{},No(I.inertia)));let{motorInertia:k,gearRatio:q}=I;o&&D.push(H("td",{},k?`${Se(k)} kg m\xB2 \xD7 ${Se(q)}\xB2`:"")),a&&D.push(H("td",{},x(I)))}return H("tr",{"data-row":S},B,D)}function b(f,S,I){let R=[H("td",{colSpan:s.length+(r?1:0)},g(S)),H("td",{},I)];return l.checked&&R.push(H("td",{colSpan:4},S.com?No(S.com):"")),H("tr",{class:"placed"},H("th",{scope:"row"},f),R)}function A(){let{base:f,tool:S}=n.table;h();let I=i.map(C);f&&I.unshift(b("base",f,"")),S&&I.push(b("tool",S,Se(S.mass)));for(let{name:R,on:P,places:U,body:B}of n.table.tips.filter(D=>D.isFrame&&D.places.length===1))I.push(b(`${R} on ${m(P)}`,{...U[0],com:B?.com},B?Se(B.mass):""));u.replaceChildren(...I),d.textContent=t.isMounted?"Joints as the file places them":`Denavit-Hartenberg table, ${t.convention} convention`,M()}function M(){for(let f of u.children)f.classList.toggle("selected",Number(f.dataset.row)===e.selected)}return l.addEventListener("change",A),n.on("fields units",A),n.on("selection",M),A(),H("section",{class:"panel table","aria-label":"Table"},or("Table of the arm",H("table",{class:"cells"},d,c,u)),H("label",{class:"check"},l,"bodies, motors, friction"))}var lf=["auto","light","dark"];function Jw({dof:n,convention:t,isMounted:e,gravity:i},s){let r=s.map(({type:l})=>l==="revolute"?"R":"P").join(""),o=i.map(l=>Se(l)).join(", "),a=e?"joints of a URDF file":`${t} D-H table`;return`${n} ${n===1?"joint":"joints"} (${r}), ${a}, gravity (${o}) m/s\xB2`}function jw(n){let t=H("button",{type:"button",class:"quiet","data-key":"theme"}),e=0,i=()=>{document.documentElement.dataset.theme=lf[e],t.textContent=`Colors: ${lf[e]}`};t.addEventListener("click",()=>{e=(e+1)%lf.length,i(),n.tell("theme")}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n.tell("theme")),i();let s=H("button",{type:"button",class:"quiet","data-key":"units"}),r=()=>s.textContent=`Angles: ${n.units.inDegrees?"degrees":"radians"}`;return s.addEventListener("click",()=>n.setUnits(!n.units.inDegrees)),n.on("units",r),r(),H("header",{},H("div",{},H("h1",{},n.table.name),H("p",{class:"said"},Jw(n.table,n.joints))),H("div",{class:"switches"},s,t))}var Ar=np(globalThis.robotTable,globalThis.robotEquations,globalThis.robotStart),Z0=Y0(Ar),J0=Pm(Ar);document.getElementById("page").append(jw(Ar),H("main",{},H("div",{class:"column fixed"},Z0.section,$0(Ar)),H("div",{class:"column"},Df(Ar),ip(Ar),J0.section)),H("footer",{},"M, V, G, \u03C4 and the motion are computed in this page by functions that robot-dynamics has proven equal to the textbook Lagrangian. SI units."));Z0.start();J0.build();globalThis.robotPage=Ar;document.documentElement.dataset.ready="true";
